# Debian packages of the two components: `cpack --config build/release/CPackConfig.cmake`, after the target
# `installable`.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME umbral)
set(CPACK_PACKAGE_CONTACT ${UMBRAL_PACKAGE_CONTACT})
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL umbral umbral-instructor)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION education)
# Folders that cpack makes are the system's to everybody, whatever the umask of whoever packs.
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
  WORLD_EXECUTE)
# Shared libraries are read off the programs.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_LIBRARY_OUTPUT_DIRECTORY})

# What compiles students' files, the headers that their interfaces include, and OpenGL, which is loaded at run time.
set(CPACK_DEBIAN_UMBRAL_PACKAGE_NAME umbral)
set(CPACK_DEBIAN_UMBRAL_DESCRIPTION "Exercises in computer graphics, checked on your own machine
 Students write one function or one shader; Umbral runs it in a sandbox beside
 a reference, and says how far apart the two are, where, and why.")
get_property(UMBRAL_GL_PACKAGES GLOBAL PROPERTY UMBRAL_GL_PACKAGES)
set(CPACK_DEBIAN_UMBRAL_PACKAGE_DEPENDS "g++, mold, libglm-dev, libgl-dev, libglfw3-dev, ${UMBRAL_GL_PACKAGES}")
set(CPACK_DEBIAN_UMBRAL_PACKAGE_RECOMMENDS "gdb")
set(CPACK_DEBIAN_UMBRAL_PACKAGE_SUGGESTS "umbral-instructor")

set(CPACK_DEBIAN_UMBRAL-INSTRUCTOR_PACKAGE_NAME umbral-instructor)
set(CPACK_DEBIAN_UMBRAL-INSTRUCTOR_DESCRIPTION "The answers to Umbral's exercises, for who grades them
 The sources of reference, drivers, known mistakes and other solutions, the
 sample class, and attacks that try this machine's sandbox.")
set(CPACK_DEBIAN_UMBRAL-INSTRUCTOR_PACKAGE_DEPENDS "umbral (= ${PROJECT_VERSION})")
# A mesh that one of the scenes names.
set(CPACK_DEBIAN_UMBRAL-INSTRUCTOR_PACKAGE_RECOMMENDS "glmark2-data")

include(CPack)
