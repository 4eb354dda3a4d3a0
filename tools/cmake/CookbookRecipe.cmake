# The house's own commands: a chapter, a recipe, a batch, a chart, a test.

include(CheckCXXCompilerFlag)

# cookbook_warnings(TARGET [OPTION…]): what this project asks of its own code, not of a game's.
function(cookbook_warnings target)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wconversion -Wshadow $<$<BOOL:${COOKBOOK_STRICT}>:-Werror>
    $<$<CONFIG:Release>:-O3> -fno-math-errno -ffp-contract=off ${ARGN})
  # g++ collects its garbage from 600 MB on, not before: a tenth less time, a tenth more memory.
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=600000>)
  # g++ 12 warns of overlapping copies inside std::string that cannot happen.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(${target} PRIVATE -Wno-restrict)
  endif()
  if(COOKBOOK_SANITIZE)
    # What is left out is found by `address` as well, and misaligned registers by the processor; with it
    # a chapter's tests take half as long again to compile.
    target_compile_options(${target} PRIVATE
      -fsanitize=address,undefined -fno-sanitize=alignment,null,object-size,pointer-overflow,vptr
      -fno-sanitize-recover=all -fno-omit-frame-pointer)
    # Checks that are called instead of built in, and the quicker choice of instructions, halve the rest.
    if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
      target_compile_options(${target} PRIVATE
        -fsanitize-address-outline-instrumentation "SHELL:-mllvm -fast-isel")
    endif()
    target_compile_definitions(${target} PRIVATE COOKBOOK_SANITIZE)
    target_link_options(${target} PRIVATE -fsanitize=address,undefined)
  endif()
endfunction()

# cookbook_lightly(TARGET [LEVEL]): optimised a little only (-Og, if LEVEL is not set), to be compiled in
# half the time. For all that is not timed and does not ask what optimisation makes of numbers. Tests,
# which run longer, ask for -O1, which costs them no more time. Clang takes up to five times as long to
# optimise a little as not at all.
function(cookbook_lightly target)
  set(level ${ARGN})
  if(NOT level)
    set(level -Og)
  endif()
  target_compile_options(${target} PRIVATE
    $<$<OR:$<CONFIG:Release>,$<BOOL:${COOKBOOK_SANITIZE}>>:$<IF:$<CXX_COMPILER_ID:Clang>,-O0,${level}>>)
  # With little optimisation g++ 12 warns of reads past short strings that it has not seen compared.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(${target} PRIVATE
      -Wno-stringop-overread -Wno-stringop-overflow -Wno-array-bounds)
  endif()
endfunction()

# cookbook_chapter(NAME [NEEDS CHAPTER]): the headers of this folder's recipes as the target cookbook::NAME.
#
# The folder's number and name are the chapter's label in ctest.
function(cookbook_chapter name)
  cmake_parse_arguments(PARSE_ARGV 1 chapter "" "NEEDS" "")
  add_library(cookbook_${name} INTERFACE)
  add_library(cookbook::${name} ALIAS cookbook_${name})
  set_target_properties(cookbook_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(cookbook_${name} INTERFACE
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/recipes>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/cookbook>)
  if(chapter_NEEDS)
    target_link_libraries(cookbook_${name} INTERFACE cookbook_${chapter_NEEDS})
  else()
    target_link_libraries(cookbook_${name} INTERFACE cookbook_common)
  endif()
  cookbook_install(cookbook_${name} ${CMAKE_CURRENT_SOURCE_DIR})
  get_filename_component(folder ${CMAKE_CURRENT_SOURCE_DIR} NAME)
  set(COOKBOOK_CHAPTER ${folder} PARENT_SCOPE)
  set(COOKBOOK_CHAPTER_TARGET cookbook_${name} PARENT_SCOPE)
  cmake_language(DEFER CALL cookbook_tests_together)
endfunction()

# cookbook_program(NAME): the target NAME from its folder, NAME/NAME.cpp; part of a recipe and of a chart.
function(cookbook_program name)
  add_executable(${name} ${name}/${name}.cpp)
  target_link_libraries(${name} PRIVATE ${COOKBOOK_CHAPTER_TARGET} ${ARGN} cookbook_tools)
  cookbook_warnings(${name})
  add_dependencies(recipes ${name})
endfunction()

# cookbook_batch(NAME [LIBRARY…]): the library cookbook::NAME from NAME_dispatch.cpp, NAME_blocks.cpp
# where there is one, and NAME_kernel.cpp in the folder NAME; the last, the inner loop, is compiled once
# for each instruction set.
#
# It is always optimised, and without Eigen's own vectors, so that no function of another file, compiled
# for a newer processor, is left for the linker to choose.
function(cookbook_batch name)
  set(library cookbook_${name})
  add_library(${library} STATIC ${COOKBOOK_WHEN_NEEDED} ${name}/${name}_dispatch.cpp)
  if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/${name}_blocks.cpp)
    target_sources(${library} PRIVATE ${name}/${name}_blocks.cpp)
  endif()
  add_library(cookbook::${name} ALIAS ${library})
  set_target_properties(${library} PROPERTIES EXPORT_NAME ${name})
  target_link_libraries(${library} PUBLIC ${COOKBOOK_CHAPTER_TARGET} ${ARGN})
  cookbook_warnings(${library})
  set(portable_flags "")
  set(avx2_flags -mavx2 -mtune=haswell) # the first processors that have it
  set(avx512_flags -mavx512f -mprefer-vector-width=512)
  check_cxx_compiler_flag(-mmove-max=256 COOKBOOK_HAS_MOVE_MAX)
  if(COOKBOOK_HAS_MOVE_MAX) # whole registers are copied at once, not by halves and quarters
    list(APPEND avx2_flags -mmove-max=256 -mstore-max=256)
    list(APPEND avx512_flags -mmove-max=512 -mstore-max=512)
  endif()
  set(all_flags -O3 -UEIGEN_MAX_STATIC_ALIGN_BYTES) # packs are wider than the 16 bytes of other files
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU") # fewer moves from register to register
    list(APPEND all_flags -frename-registers)
  endif()
  set(instruction_sets portable)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" AND NOT COOKBOOK_PLAIN)
    list(APPEND instruction_sets avx2 avx512)
    target_compile_definitions(${library} PRIVATE COOKBOOK_KERNELS_X86)
  endif()
  foreach(set IN LISTS instruction_sets)
    add_library(${name}_${set} OBJECT ${COOKBOOK_WHEN_NEEDED} ${name}/${name}_kernel.cpp)
    target_link_libraries(${name}_${set} PRIVATE ${COOKBOOK_CHAPTER_TARGET})
    target_compile_definitions(${name}_${set} PRIVATE
      COOKBOOK_INSTRUCTION_SET=${set} EIGEN_DONT_VECTORIZE)
    cookbook_warnings(${name}_${set} ${all_flags} ${${set}_flags})
    target_sources(${library} PRIVATE $<TARGET_OBJECTS:${name}_${set}>)
    if(COOKBOOK_TESTS AND NOT COOKBOOK_SANITIZE AND NOT set STREQUAL "portable")
      add_test(NAME ${name}.${set} COMMAND sh ${PROJECT_SOURCE_DIR}/tools/cmake/check_kernel.sh
        ${set} $<TARGET_OBJECTS:${name}_${set}>)
      set_tests_properties(${name}.${set} PROPERTIES LABELS "${COOKBOOK_CHAPTER};${name}" TIMEOUT 60)
    endif()
  endforeach()
  cookbook_install_target(${library})
endfunction()

# cookbook_helper(FOLDER NAME [LIGHT|BUSY] [LIBRARY…]): FOLDER/trial/NAME.cpp, compiled once for several
# programs and tests. What is LIGHT, or BUSY, is not timed.
function(cookbook_helper folder name)
  cmake_parse_arguments(PARSE_ARGV 2 helper "LIGHT;BUSY" "" "")
  add_library(${name} STATIC EXCLUDE_FROM_ALL ${folder}/trial/${name}.cpp)
  target_link_libraries(${name} PUBLIC ${COOKBOOK_CHAPTER_TARGET} ${helper_UNPARSED_ARGUMENTS})
  cookbook_warnings(${name})
  if(helper_LIGHT)
    cookbook_compiled(${name} light)
  elseif(helper_BUSY)
    cookbook_compiled(${name} busy)
  else()
    cookbook_compiled(${name} timed)
  endif()
endfunction()

# cookbook_compiled(TARGET light|busy|timed): optimised a little only, or in full, with the headers that
# are precompiled for it. What is busy runs for long if it is not optimised at all, so that clang, which
# does nothing in between, optimises it in full.
function(cookbook_compiled target kind)
  if(kind STREQUAL "busy" AND CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND NOT COOKBOOK_SANITIZE)
    set(kind timed)
  elseif(kind STREQUAL "busy")
    set(kind light)
  endif()
  set(headers cookbook_tools)
  if(kind STREQUAL "light")
    cookbook_lightly(${target})
    set(headers cookbook_light_headers)
  endif()
  if(TARGET ${headers})
    target_precompile_headers(${target} REUSE_FROM ${headers})
  endif()
endfunction()

# cookbook_timed(PROGRAM): a program that measures time: the build fails where two of its objects hold the
# same function, compiled in two ways. Other programs may mix -Og and -O3, which changes no number of
# theirs; what is compiled for newer processors shares no function with anything, as check_kernel.sh holds.
function(cookbook_timed program)
  cookbook_compiled(${program} timed)
  if(CMAKE_EXPORT_COMPILE_COMMANDS AND CMAKE_GENERATOR STREQUAL "Ninja")
    add_custom_command(TARGET ${program} POST_BUILD WORKING_DIRECTORY ${CMAKE_BINARY_DIR} VERBATIM
      COMMAND sh -c "sh '${PROJECT_SOURCE_DIR}/tools/cmake/check_instances.sh' compile_commands.json \
        $('${CMAKE_MAKE_PROGRAM}' -t inputs ${program} | grep '\\.o$')")
  endif()
endfunction()

# cookbook_precompiled(NAME HEADER [LIBRARY…]): headers that every program, or every test, reads first
# anyway, compiled once. Nothing relies on them: each file includes what it needs.
function(cookbook_precompiled name header)
  file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp "")
  add_library(${name} STATIC ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  target_link_libraries(${name} PRIVATE ${ARGN})
  cookbook_warnings(${name})
  target_precompile_headers(${name} PRIVATE ${header})
endfunction()

# All programs, but no tests.
if(COOKBOOK_RECIPES)
  add_custom_target(recipes)
endif()

# cookbook_recipe(NAME [LONG|BUSY|TIMED] [LIBRARY…]): NAME.hpp, NAME.cpp and NAME.expected in the folder NAME
# make the program NAME, the checks of its output and its figures, and the tests in
# tests/CHAPTER/NAME_test.cpp. What is LONG runs for longer than it compiles, and is optimised; what is TIMED
# measures time when it is asked to.
function(cookbook_recipe name)
  set_property(GLOBAL APPEND PROPERTY COOKBOOK_RECIPE_NAMES ${name})
  cmake_parse_arguments(PARSE_ARGV 1 recipe "LONG;BUSY;TIMED" "" "")
  if(COOKBOOK_RECIPES)
    cookbook_program(${name} ${recipe_UNPARSED_ARGUMENTS})
    if(recipe_TIMED)
      cookbook_timed(${name})
    elseif(recipe_LONG)
      cookbook_compiled(${name} timed)
    elseif(recipe_BUSY)
      cookbook_compiled(${name} busy)
    else()
      cookbook_compiled(${name} light)
    endif()
  endif()
  if(COOKBOOK_TESTS AND COOKBOOK_RECIPES)
    add_test(NAME ${name}.output COMMAND sh ${PROJECT_SOURCE_DIR}/tools/cmake/check_output.sh compare
      $<TARGET_FILE:${name}> ${name} ${CMAKE_CURRENT_SOURCE_DIR}/${name}/${name}.expected
      ${PROJECT_SOURCE_DIR}/chapters/figures/${COOKBOOK_CHAPTER}
      ${CMAKE_CURRENT_BINARY_DIR}/${name}.drawn)
    set_tests_properties(${name}.output PROPERTIES
      LABELS "${COOKBOOK_CHAPTER};${name}" TIMEOUT 300)
  endif()
  cookbook_test(${name} ${recipe_UNPARSED_ARGUMENTS})
endfunction()

# cookbook_example(FOLDER NAME [LIBRARY…]): FOLDER/NAME_example.cpp, a complete program of at most 20 lines
# that a page shows whole, as the target NAME_example; the test NAME_example.output compares what it prints
# with FOLDER/NAME_example.expected. It is no recipe, and `./cookbook accept NAME_example` takes new output.
function(cookbook_example folder name)
  if(NOT COOKBOOK_RECIPES)
    return()
  endif()
  set(target ${name}_example)
  add_executable(${target} ${folder}/${target}.cpp)
  target_link_libraries(${target} PRIVATE ${COOKBOOK_CHAPTER_TARGET} ${ARGN})
  cookbook_warnings(${target})
  cookbook_lightly(${target})
  add_dependencies(recipes ${target})
  if(TARGET ${folder}) # for ./cookbook test FOLDER, where the recipe is told first
    add_dependencies(${folder} ${target})
  endif()
  if(COOKBOOK_TESTS)
    add_test(NAME ${target}.output COMMAND sh ${PROJECT_SOURCE_DIR}/tools/cmake/check_output.sh compare
      $<TARGET_FILE:${target}> ${target} ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/${target}.expected
      ${PROJECT_SOURCE_DIR}/chapters/figures/${COOKBOOK_CHAPTER}
      ${CMAKE_CURRENT_BINARY_DIR}/${target}.drawn)
    set_tests_properties(${target}.output PROPERTIES
      LABELS "${COOKBOOK_CHAPTER};${folder}" TIMEOUT 300)
  endif()
endfunction()

# cookbook_refusal(NAME WORDS [ARGUMENT…]): the program NAME, called like this, refuses with the words.
function(cookbook_refusal name words)
  if(COOKBOOK_TESTS AND COOKBOOK_RECIPES)
    list(JOIN ARGN " " called)
    add_test(NAME "${name} refuses ${called}" COMMAND ${name} ${ARGN})
    set_tests_properties("${name} refuses ${called}" PROPERTIES
      LABELS "${COOKBOOK_CHAPTER};${name}" TIMEOUT 60 PASS_REGULAR_EXPRESSION "error: ${words}")
  endif()
endfunction()

# cookbook_does_not_compile(NAME DEFINITION WORDS): tests/CHAPTER/NAME.cpp compiles, and does not where the
# definition is made: the compiler then says the words.
function(cookbook_does_not_compile name definition words)
  if(NOT COOKBOOK_TESTS OR NOT COOKBOOK_UNIT_TESTS)
    return()
  endif()
  set(compile ${CMAKE_CXX_COMPILER} -std=c++20 -fsyntax-only -I${PROJECT_SOURCE_DIR}
    -I${PROJECT_SOURCE_DIR}/recipes
    -isystem$<JOIN:$<TARGET_PROPERTY:Eigen3::Eigen,INTERFACE_INCLUDE_DIRECTORIES>,$<SEMICOLON>-isystem>
    ${PROJECT_SOURCE_DIR}/tests/${COOKBOOK_CHAPTER}/${name}.cpp)
  if(NOT TEST ${name}.compiles)
    add_test(NAME ${name}.compiles COMMAND ${compile} COMMAND_EXPAND_LISTS)
  endif()
  add_test(NAME ${name}.${definition} COMMAND ${compile} -D${definition} COMMAND_EXPAND_LISTS)
  set_tests_properties(${name}.${definition} PROPERTIES
    PASS_REGULAR_EXPRESSION "error: static[ _]assert[a-z ]*:? *\"?${words}")
  set_tests_properties(${name}.compiles ${name}.${definition} PROPERTIES
    LABELS "${COOKBOOK_CHAPTER};${name}" TIMEOUT 300)
endfunction()

# cookbook_chart(NAME [LIBRARY…]): a program that measures time; its chart belongs to the book and is
# built with it. Only its unit tests run in ctest; sanitizers leave them out, for what they link is
# large.
function(cookbook_chart name)
  if(COOKBOOK_RECIPES AND COOKBOOK_BOOK)
    cookbook_program(${name} ${ARGN})
    cookbook_timed(${name})
    set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL TRUE)
    set(charts ${CMAKE_BINARY_DIR}/charts)
    add_custom_command(OUTPUT ${charts}/${name}.measured
      COMMAND ${CMAKE_COMMAND} -E make_directory ${charts}
      COMMAND ${name} --effort ${COOKBOOK_EFFORT} --out ${charts} > ${charts}/${name}.measured
      DEPENDS ${name} COMMENT "Measuring and drawing the chart ${name}" VERBATIM)
    add_custom_target(${name}.chart DEPENDS ${charts}/${name}.measured)
    set_property(GLOBAL APPEND PROPERTY COOKBOOK_CHART_TARGETS ${name}.chart)
  endif()
  if(NOT COOKBOOK_SANITIZE)
    cookbook_test(${name} ${ARGN})
  endif()
endfunction()

# cookbook_test(NAME [LIBRARY…]): tests/CHAPTER/NAME_test.cpp and NAME_accuracy_test.cpp, if there is
# one; sanitizers leave the latter out, for it asks the same code of more pairs.
#
# Each test is a program of its own, for `./cookbook test NAME`, and a part of one of the chapter's,
# for all others: what they have in common is compiled once.
function(cookbook_test name)
  if(NOT COOKBOOK_TESTS OR NOT COOKBOOK_UNIT_TESTS)
    return()
  endif()
  set(folder ${PROJECT_SOURCE_DIR}/tests/${COOKBOOK_CHAPTER})
  cookbook_test_program(${name}_test ${folder}/${name}_test.cpp ${ARGN})
  set_target_properties(${name}_test PROPERTIES EXCLUDE_FROM_ALL TRUE)
  add_test(NAME ${name}.alone CONFIGURATIONS alone COMMAND ${name}_test)
  set_tests_properties(${name}.alone PROPERTIES LABELS ${name} TIMEOUT 900)
  set_property(DIRECTORY APPEND PROPERTY COOKBOOK_TOGETHER ${name})
  set_property(DIRECTORY APPEND PROPERTY COOKBOOK_TOGETHER_LIBRARIES ${ARGN})
  if(EXISTS ${folder}/${name}_accuracy_test.cpp AND NOT COOKBOOK_SANITIZE)
    cookbook_test_program(${name}_accuracy_test ${folder}/${name}_accuracy_test.cpp ${ARGN})
    add_dependencies(${name}_test ${name}_accuracy_test)
    add_test(NAME ${name}_accuracy.unit COMMAND ${name}_accuracy_test)
    set_tests_properties(${name}_accuracy.unit PROPERTIES
      LABELS "${COOKBOOK_CHAPTER};${name}" TIMEOUT 900)
  endif()
endfunction()

# A program of tests, from SOURCE; optimised a little only, unless COOKBOOK_OPTIMISED_TESTS names it.
function(cookbook_test_program target source)
  add_executable(${target} ${source})
  target_link_libraries(${target} PRIVATE
    ${COOKBOOK_CHAPTER_TARGET} cookbook_exact cookbook_tools cookbook_test_main ${ARGN})
  cookbook_warnings(${target})
  if(NOT target IN_LIST COOKBOOK_OPTIMISED_TESTS)
    cookbook_lightly(${target} -O1)
    target_precompile_headers(${target} REUSE_FROM cookbook_test_headers)
  endif()
endfunction()

# The tests of a chapter, COOKBOOK_TESTS_A_SOURCE (three, if it is not set) in one source: first what
# the chapter has compiled already, as COOKBOOK_INSTANCES says, then all that they include, then each
# test in a namespace of its own. Where all is checked, twice as many: that takes a third less time,
# and up to 1.5 GB a source. Sanitizers leave out what is tagged [long].
#
# Where a chapter sets COOKBOOK_OPTIMISED, a library of its tests, that is linked first: of a function that
# several files hold the linker takes the first. Tests alone do without.
function(cookbook_tests_together)
  get_property(names DIRECTORY PROPERTY COOKBOOK_TOGETHER)
  get_property(libraries DIRECTORY PROPERTY COOKBOOK_TOGETHER_LIBRARIES)
  if(NOT COOKBOOK_TESTS_A_SOURCE)
    set(COOKBOOK_TESTS_A_SOURCE 3)
  endif()
  if(COOKBOOK_STRICT)
    math(EXPR COOKBOOK_TESTS_A_SOURCE "2 * ${COOKBOOK_TESTS_A_SOURCE}")
  endif()
  set(number 0)
  set(only "")
  if(COOKBOOK_SANITIZE)
    set(only "~[long]")
  endif()
  while(names)
    math(EXPR number "${number} + 1")
    list(SUBLIST names 0 ${COOKBOOK_TESTS_A_SOURCE} some)
    list(REMOVE_ITEM names ${some})
    set(program ${COOKBOOK_CHAPTER}_tests_${number})
    set(includes "")
    if(COOKBOOK_INSTANCES)
      set(includes "#include \"${COOKBOOK_INSTANCES}\"")
    endif()
    set(tests "")
    foreach(name IN LISTS some)
      set(source ${PROJECT_SOURCE_DIR}/tests/${COOKBOOK_CHAPTER}/${name}_test.cpp)
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
      file(STRINGS ${source} lines REGEX "^#include")
      list(APPEND includes ${lines})
      string(APPEND tests "namespace test_${name}\n{\n#include \"${source}\"\n}\n")
      add_test(NAME ${name}.unit COMMAND ${program} -\# "[#${name}_test]${only}")
      set_tests_properties(${name}.unit PROPERTIES LABELS ${COOKBOOK_CHAPTER} TIMEOUT 900
        FAIL_REGULAR_EXPRESSION "No test cases matched;No tests ran")
      if(name IN_LIST COOKBOOK_LONG_TESTS) # they come first, so that nothing waits for them at the end
        set_tests_properties(${name}.unit PROPERTIES COST 40)
      endif()
    endforeach()
    list(REMOVE_DUPLICATES includes)
    list(JOIN includes "\n" includes)
    set(source ${CMAKE_CURRENT_BINARY_DIR}/${program}.cpp)
    file(CONFIGURE OUTPUT ${source} CONTENT "${includes}\n${tests}" @ONLY)
    cookbook_test_program(${program} ${source} ${libraries})
    if(COOKBOOK_OPTIMISED)
      target_link_options(${program} PRIVATE $<TARGET_OBJECTS:${COOKBOOK_OPTIMISED}>)
    endif()
    target_compile_options(${program} PRIVATE -Wno-shadow) # a name of another test's headers
  endwhile()
endfunction()
