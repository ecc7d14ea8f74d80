# PNG files and safe writing of files; apart from umbral-framework, so that no student's run loads libpng.
add_library(umbral-png STATIC ${CMAKE_CURRENT_LIST_DIR}/png.cpp)
target_include_directories(umbral-png PUBLIC ${CMAKE_CURRENT_LIST_DIR}/../..)
target_link_libraries(umbral-png PUBLIC glm::glm PRIVATE umbral-warnings PNG::PNG)
