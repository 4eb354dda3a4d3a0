cmake_minimum_required(VERSION 3.22)
project(my_game LANGUAGES CXX)

add_subdirectory(cookbook)

add_executable(my_game main.cpp)
target_link_libraries(my_game PRIVATE cookbook::world)
