# Runs a recipe's program in an empty folder and compares what it prints and draws, byte for byte,
# with the files that the pages show. With -D accept=ON it takes the new ones instead.
#
# cmake -D program=FILE -D name=NAME -D expected=FILE -D figures=FOLDER -D drawn=FOLDER -P …

cmake_minimum_required(VERSION 3.22)

file(REMOVE_RECURSE ${drawn})
file(MAKE_DIRECTORY ${drawn})
execute_process(COMMAND ${program} --out ${drawn}
  OUTPUT_FILE ${drawn}/${name}.printed ERROR_VARIABLE complaint RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${name} ended with ${status}: ${complaint}")
endif()

file(GLOB figures_drawn RELATIVE ${drawn} ${drawn}/*.svg ${drawn}/*.html)
if(accept)
  file(MAKE_DIRECTORY ${figures})
  configure_file(${drawn}/${name}.printed ${expected} COPYONLY)
  foreach(figure ${figures_drawn})
    configure_file(${drawn}/${figure} ${figures}/${figure} COPYONLY)
  endforeach()
  message(STATUS "accepted ${expected} and the figures: ${figures_drawn}")
  return()
endif()

function(compare made kept)
  if(NOT EXISTS ${kept})
    message(SEND_ERROR "${kept} is missing. If ${made} is right: ./cookbook accept ${name}")
    return()
  endif()
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${made} ${kept} RESULT_VARIABLE differs)
  if(differs)
    find_program(diff_program diff)
    if(diff_program)
      execute_process(COMMAND ${diff_program} -u ${kept} ${made} OUTPUT_VARIABLE changes)
      string(SUBSTRING "${changes}" 0 4000 changes)
    endif()
    message(SEND_ERROR "${made} differs from ${kept}. If the new one is right: "
      "./cookbook accept ${name}\n${changes}")
  endif()
endfunction()

compare(${drawn}/${name}.printed ${expected})
foreach(figure ${figures_drawn})
  compare(${drawn}/${figure} ${figures}/${figure})
endforeach()
file(GLOB figures_kept RELATIVE ${figures} ${figures}/${name}.svg ${figures}/${name}.html)
foreach(figure ${figures_kept})
  if(NOT figure IN_LIST figures_drawn)
    message(SEND_ERROR "${name} no longer draws ${figures}/${figure}.")
  endif()
endforeach()
