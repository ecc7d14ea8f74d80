# Scenes and their files; apart from umbral-framework, so that no student's run loads a JSON parser.
add_library(umbral-scene STATIC ${CMAKE_CURRENT_LIST_DIR}/node.cpp ${CMAKE_CURRENT_LIST_DIR}/shapes.cpp ${CMAKE_CURRENT_LIST_DIR}/scene_json.cpp)
target_include_directories(umbral-scene PUBLIC ${CMAKE_CURRENT_LIST_DIR}/../..)
target_link_libraries(umbral-scene PUBLIC glm::glm PRIVATE umbral-warnings fmt::fmt nlohmann_json::nlohmann_json)
