# Builds the game of the README, as a reader would: its CMake text and its C++ text are cut out of the
# README, once with the cookbook as a folder of the game, once with the cookbook installed. Then the first
# program of chapter 6 by the CMake text of its page, in both ways.
#
# cmake -D source=REPOSITORY -D build=BUILD_FOLDER -D work=EMPTY_FOLDER -D compiler=C++ -D generator=GENERATOR
#   -P …

cmake_minimum_required(VERSION 3.22)

file(READ ${source}/README.md readme)
function(cut language result)
  string(REGEX MATCH "```${language}\n([^`]*)```" found "${readme}")
  if(NOT found)
    message(FATAL_ERROR "README.md has no block of ${language}")
  endif()
  set(${result} "${CMAKE_MATCH_1}" PARENT_SCOPE)
endfunction()

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    string(REPLACE ";" " " command "${ARGN}")
    message(FATAL_ERROR "${command} ended with ${status}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(build_game folder)
  # -O1: this is about building and linking, and the bits are those of -O3, as the test `bits` asserts
  run(${CMAKE_COMMAND} -G ${generator} -S ${folder} -B ${folder}/build -DCMAKE_CXX_COMPILER=${compiler}
      -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O1 ${ARGN})
  run(${CMAKE_COMMAND} --build ${folder}/build)
  run(${folder}/build/my_game)
  if(NOT output STREQUAL printed)
    message(SEND_ERROR "the game in ${folder} printed \"${output}\"")
  endif()
endfunction()

# The block that follows the sentence about what the game prints.
string(REGEX MATCH "It prints [^`]*```\n([^`]*)```" found "${readme}")
set(printed "${CMAKE_MATCH_1}")
cut(cmake cmake_text)
cut(cpp cpp_text)
file(REMOVE_RECURSE ${work})

file(WRITE ${work}/folder/main.cpp "${cpp_text}")
file(WRITE ${work}/folder/CMakeLists.txt "${cmake_text}")
file(CREATE_LINK ${source} ${work}/folder/cookbook SYMBOLIC)
build_game(${work}/folder)

string(REPLACE "add_subdirectory(cookbook)" "find_package(cookbook REQUIRED)" cmake_text "${cmake_text}")
file(WRITE ${work}/installed/main.cpp "${cpp_text}")
file(WRITE ${work}/installed/CMakeLists.txt "${cmake_text}")
run(${CMAKE_COMMAND} --install ${build} --prefix ${work}/prefix)
build_game(${work}/installed -DCMAKE_PREFIX_PATH=${work}/prefix)

# Every header that was installed can be included by a game that has nothing but Eigen.
file(GLOB_RECURSE headers RELATIVE ${work}/prefix/include/cookbook ${work}/prefix/include/*.hpp)
set(includes "")
foreach(header ${headers})
  string(APPEND includes "#include \"${header}\"\n")
endforeach()
file(WRITE ${work}/installed/main.cpp "${includes}${cpp_text}")
string(REPLACE "cookbook::sphere_manifolds" "cookbook::world_headers" cmake_text "${cmake_text}")
file(WRITE ${work}/installed/CMakeLists.txt "${cmake_text}")
build_game(${work}/installed -DCMAKE_PREFIX_PATH=${work}/prefix)

# The world, compiled: as a part of the game, and as it was installed.
file(READ ${source}/tests/install/game_of_the_world.cmake cmake_text)
set(first_world ${source}/tests/06_world/first_world)
file(READ ${first_world}.expected printed)
foreach(way folder installed)
  file(COPY_FILE ${first_world}.cpp ${work}/${way}/main.cpp)
  file(WRITE ${work}/${way}/CMakeLists.txt "${cmake_text}")
  build_game(${work}/${way} -DCMAKE_PREFIX_PATH=${work}/prefix)
  string(REPLACE "add_subdirectory(cookbook)" "find_package(cookbook REQUIRED)" cmake_text "${cmake_text}")
endforeach()
