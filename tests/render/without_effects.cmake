# Writes a source file of the engine as it would be if no effect had ever been written: each question for one is "no".
# cmake -DFROM=file -DTO=file -P without_effects.cmake
file(READ ${FROM} text)
string(REGEX REPLACE "effects\\.(textured|specular|smooth|positional|two_sided|clipped)" "false" text "${text}")
file(WRITE ${TO} "${text}")
