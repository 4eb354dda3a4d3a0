# Installing the headers, so that a game can find_package(cookbook).

include(CMakePackageConfigHelpers)

# A game that only adds the folder builds nothing that it does not link.
set(COOKBOOK_WHEN_NEEDED "")
if(NOT PROJECT_IS_TOP_LEVEL)
  set(COOKBOOK_WHEN_NEEDED EXCLUDE_FROM_ALL)
endif()

# cookbook_install_target(TARGET): part of the package.
function(cookbook_install_target target)
  if(COOKBOOK_INSTALL)
    install(TARGETS ${target} EXPORT cookbook)
  endif()
endfunction()

# cookbook_install(TARGET FOLDER…): the headers of folders below the repository's include roots, but
# not those in trials, nor the inner loops of batches.
function(cookbook_install target)
  cookbook_install_target(${target})
  if(NOT COOKBOOK_INSTALL)
    return()
  endif()
  foreach(folder IN LISTS ARGN)
    file(RELATIVE_PATH below ${PROJECT_SOURCE_DIR}/recipes ${folder})
    if(below MATCHES "^\\.\\.")
      file(RELATIVE_PATH below ${PROJECT_SOURCE_DIR} ${folder})
    endif()
    install(DIRECTORY ${folder}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/cookbook/${below}
      FILES_MATCHING PATTERN "*.hpp"
      PATTERN "trial" EXCLUDE
      PATTERN "*_kernel.hpp" EXCLUDE)
  endforeach()
endfunction()

if(COOKBOOK_INSTALL)
  set(COOKBOOK_CONFIG_FOLDER ${CMAKE_INSTALL_LIBDIR}/cmake/cookbook)
  install(EXPORT cookbook NAMESPACE cookbook:: DESTINATION ${COOKBOOK_CONFIG_FOLDER}
    FILE cookbookTargets.cmake)
  file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/cookbookConfig.cmake
"include(CMakeFindDependencyMacro)
find_dependency(Eigen3)
include(\${CMAKE_CURRENT_LIST_DIR}/cookbookTargets.cmake)
")
  write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/cookbookConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
  install(FILES
    ${CMAKE_CURRENT_BINARY_DIR}/cookbookConfig.cmake
    ${CMAKE_CURRENT_BINARY_DIR}/cookbookConfigVersion.cmake
    DESTINATION ${COOKBOOK_CONFIG_FOLDER})
endif()
