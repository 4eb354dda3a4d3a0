# Installing the headers, so that a game can find_package(cookbook).

include(CMakePackageConfigHelpers)

# cookbook_install(TARGET FOLDER): the headers of a folder below the repository's include roots.
function(cookbook_install target folder)
  install(TARGETS ${target} EXPORT cookbook)
  file(RELATIVE_PATH below_recipes ${PROJECT_SOURCE_DIR}/recipes ${folder})
  if(below_recipes MATCHES "^\\.\\.")
    file(RELATIVE_PATH below_recipes ${PROJECT_SOURCE_DIR} ${folder})
  endif()
  install(DIRECTORY ${folder}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/cookbook/${below_recipes}
    FILES_MATCHING PATTERN "*.hpp" PATTERN "pairs_file.hpp" EXCLUDE)
endfunction()

set(COOKBOOK_CONFIG_FOLDER ${CMAKE_INSTALL_LIBDIR}/cmake/cookbook)
install(EXPORT cookbook NAMESPACE cookbook:: DESTINATION ${COOKBOOK_CONFIG_FOLDER}
  FILE cookbookTargets.cmake)
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/cookbookConfig.cmake
"include(CMakeFindDependencyMacro)
find_dependency(Eigen3)
include(\${CMAKE_CURRENT_LIST_DIR}/cookbookTargets.cmake)
")
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/cookbookConfigVersion.cmake
  COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES
  ${CMAKE_CURRENT_BINARY_DIR}/cookbookConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/cookbookConfigVersion.cmake
  DESTINATION ${COOKBOOK_CONFIG_FOLDER})
