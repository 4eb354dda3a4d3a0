# Live figures: a recipe's live.cpp as a program, and as WebAssembly for the book.

# Where clang can compile for WebAssembly, and its linker and libraries are there.
find_program(COOKBOOK_WASM_CXX NAMES clang++ clang++-19 clang++-14)
find_program(COOKBOOK_WASM_LINKER NAMES wasm-ld wasm-ld-19 wasm-ld-14)
set(COOKBOOK_WASM OFF)
if(COOKBOOK_WASM_CXX AND COOKBOOK_WASM_LINKER)
  execute_process(COMMAND "${COOKBOOK_WASM_CXX}" --target=wasm32-wasi --print-libgcc-file-name
    OUTPUT_VARIABLE runtime OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(EXISTS "/usr/include/wasm32-wasi/c++/v1/vector" AND EXISTS "${runtime}")
    set(COOKBOOK_WASM ON)
  endif()
endif()
if(NOT COOKBOOK_WASM)
  message(STATUS "Live figures are stills: no clang for WebAssembly with libc++ (./cookbook installs it)")
endif()

get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
set(COOKBOOK_WASM_COMPILE "${COOKBOOK_WASM_CXX}" --target=wasm32-wasi --sysroot=/usr -std=c++20 -O2 -DNDEBUG
  -ffp-contract=off -fno-rtti -fno-math-errno -DEIGEN_DONT_VECTORIZE -isystem "${eigen}"
  -I "${PROJECT_SOURCE_DIR}" -I "${PROJECT_SOURCE_DIR}/recipes")

# cookbook_wasm_object(RESULT SOURCE [OPTION…]): the object of a source for WebAssembly, compiled with options of
# its own.
function(cookbook_wasm_object result source)
  file(RELATIVE_PATH relative "${PROJECT_SOURCE_DIR}" "${source}")
  string(REPLACE "/" "_" stem "${relative}")
  if(ARGN)
    string(MD5 mark "${ARGN}")
    string(SUBSTRING ${mark} 0 8 mark)
    string(APPEND stem "_${mark}")
  endif()
  set(object "${CMAKE_BINARY_DIR}/live/${stem}.o")
  get_property(known GLOBAL PROPERTY "COOKBOOK_WASM_${stem}")
  if(NOT known)
    set_property(GLOBAL PROPERTY "COOKBOOK_WASM_${stem}" ON)
    add_custom_command(OUTPUT "${object}"
      COMMAND ${COOKBOOK_WASM_COMPILE} ${ARGN} -MD -MF "${object}.d" -MT "${object}" -c "${source}" -o "${object}"
      DEPENDS "${source}" DEPFILE "${object}.d" COMMENT "Compiling ${relative} for WebAssembly" VERBATIM)
  endif()
  set(${result} "${object}" PARENT_SCOPE)
endfunction()

# The kit, natively: where it is shown, and what every figure is made of.
if(COOKBOOK_RECIPES)
  set(COOKBOOK_LIVE_KIT page curves session session_json)
  list(TRANSFORM COOKBOOK_LIVE_KIT PREPEND "${PROJECT_SOURCE_DIR}/tools/live/")
  list(TRANSFORM COOKBOOK_LIVE_KIT APPEND ".cpp")
  file(MAKE_DIRECTORY "${CMAKE_BINARY_DIR}/live")
endif()

# cookbook_live_kit(): the library of all live figures' programs; with a window where SDL2 is installed.
function(cookbook_live_kit)
  find_package(SDL2 CONFIG QUIET)
  set(hosts controls no_window terminal)
  if(TARGET SDL2::SDL2)
    set(hosts controls panel terminal text window)
  else()
    message(STATUS "Live figures have no window: SDL2 is not installed (./cookbook play installs it)")
  endif()
  list(TRANSFORM hosts PREPEND ${PROJECT_SOURCE_DIR}/tools/live/hosts/)
  list(TRANSFORM hosts APPEND .cpp)
  add_library(cookbook_live STATIC ${COOKBOOK_LIVE_KIT} ${PROJECT_SOURCE_DIR}/tools/live/native.cpp
    ${PROJECT_SOURCE_DIR}/tools/live/still.cpp ${hosts})
  target_link_libraries(cookbook_live PUBLIC cookbook_tools)
  if(TARGET SDL2::SDL2)
    target_link_libraries(cookbook_live PRIVATE SDL2::SDL2)
  endif()
  cookbook_warnings(cookbook_live)
  cookbook_lightly(cookbook_live)
endfunction()

# cookbook_live(FOLDER [LIBRARY…] [SOURCES SOURCE…] [OPTIONS OPTION…]): FOLDER/live.cpp as the live figure FOLDER.
#
# The program FOLDER_live shows it outside of a page; the test FOLDER_live.output compares its tour with
# FOLDER/live.expected. The target `live` compiles it, with the SOURCES beside it that its libraries are made
# of, for the book's pages; OPTIONS are the compiler's for all of these. `./cookbook accept FOLDER_live` takes a new tour.
function(cookbook_live folder)
  if(NOT COOKBOOK_RECIPES)
    return()
  endif()
  cmake_parse_arguments(PARSE_ARGV 1 live "" "" "SOURCES;OPTIONS")
  set(target ${folder}_live)
  file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/${target}_name.cpp.new"
    "extern const char* const cookbook_live_name;\nconst char* const cookbook_live_name = \"${folder}\";\n")
  configure_file("${CMAKE_CURRENT_BINARY_DIR}/${target}_name.cpp.new"
    "${CMAKE_CURRENT_BINARY_DIR}/${target}_name.cpp" COPYONLY)
  add_executable(${target} ${folder}/live.cpp "${CMAKE_CURRENT_BINARY_DIR}/${target}_name.cpp")
  target_link_libraries(${target} PRIVATE
    cookbook_live ${COOKBOOK_CHAPTER_TARGET} ${live_UNPARSED_ARGUMENTS} cookbook_tools)
  cookbook_warnings(${target})
  # A picture is drawn for each step that is seen.
  file(STRINGS ${folder}/live.cpp shows REGEX "[.]show\\(")
  if(shows)
    cookbook_compiled(${target} timed)
  else()
    cookbook_compiled(${target} busy)
  endif()
  if(COOKBOOK_TESTS)
    add_test(NAME ${target}.output COMMAND sh ${PROJECT_SOURCE_DIR}/tools/cmake/check_output.sh compare
      $<TARGET_FILE:${target}> ${target} ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/live.expected
      ${PROJECT_SOURCE_DIR}/chapters/figures/${COOKBOOK_CHAPTER} ${CMAKE_CURRENT_BINARY_DIR}/${target}.drawn)
    set_tests_properties(${target}.output PROPERTIES LABELS "${COOKBOOK_CHAPTER};${folder}" TIMEOUT 300)
  endif()

  set(still "${CMAKE_BINARY_DIR}/live/${folder}_still.html")
  add_custom_command(OUTPUT "${still}" COMMAND ${target} --still "${still}" DEPENDS ${target}
    COMMENT "Drawing the still of the live figure ${folder}" VERBATIM)
  set(made "${still}")
  if(COOKBOOK_WASM)
    file(GLOB plot CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/tools/plot/*.cpp" "${PROJECT_SOURCE_DIR}/tools/plot/*/*.cpp")
    set(objects "")
    foreach(source IN LISTS COOKBOOK_LIVE_KIT plot)
      cookbook_wasm_object(object "${source}")
      list(APPEND objects "${object}")
    endforeach()
    foreach(source tools/live/web.cpp tools/program/table.cpp)
      cookbook_wasm_object(object "${PROJECT_SOURCE_DIR}/${source}")
      list(APPEND objects "${object}")
    endforeach()
    foreach(source IN LISTS live_SOURCES)
      cookbook_wasm_object(object "${PROJECT_SOURCE_DIR}/${source}" ${live_OPTIONS})
      list(APPEND objects "${object}")
    endforeach()
    cookbook_wasm_object(object "${CMAKE_CURRENT_SOURCE_DIR}/${folder}/live.cpp" ${live_OPTIONS})
    set(module "${CMAKE_BINARY_DIR}/live/${folder}.wasm")
    # A stack of 1 MB, since Eigen puts up to 128 kB of a dense solver there; one that overflows is trapped.
    # Linked without -O, or clang calls binaryen where that is installed.
    add_custom_command(OUTPUT "${module}.js"
      COMMAND "${COOKBOOK_WASM_CXX}" --target=wasm32-wasi --sysroot=/usr -mexec-model=reactor
              -Wl,--strip-all -Wl,--stack-first -Wl,-z,stack-size=1048576 "${object}" ${objects} -o "${module}"
      COMMAND sh "${PROJECT_SOURCE_DIR}/tools/live/embed.sh" ${folder} "${module}" "${module}.js"
      DEPENDS "${object}" ${objects} "${PROJECT_SOURCE_DIR}/tools/live/embed.sh"
      COMMENT "Linking the live figure ${folder}" VERBATIM)
    list(APPEND made "${module}.js")
  endif()
  add_custom_target(${folder}.live DEPENDS ${made})
  set_property(GLOBAL APPEND PROPERTY COOKBOOK_LIVE_FIGURES ${folder})
endfunction()
