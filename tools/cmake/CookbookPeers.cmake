# Other libraries to time beside the recipes; charts leave out what is not installed.
#
# cookbook_peers links to whatever was found and defines COOKBOOK_HAS_ODE, COOKBOOK_HAS_BULLET,
# COOKBOOK_HAS_FCL, COOKBOOK_HAS_EMBREE, COOKBOOK_HAS_CGAL.

add_library(cookbook_peers INTERFACE)
if(COOKBOOK_PEERS)
  find_package(PkgConfig QUIET)
  if(PkgConfig_FOUND)
    pkg_check_modules(ODE QUIET IMPORTED_TARGET ode)
    pkg_check_modules(BULLET QUIET IMPORTED_TARGET bullet)
    pkg_check_modules(FCL QUIET IMPORTED_TARGET fcl)
  endif()
  if(TARGET PkgConfig::ODE)
    target_link_libraries(cookbook_peers INTERFACE PkgConfig::ODE)
    target_compile_definitions(cookbook_peers INTERFACE COOKBOOK_HAS_ODE)
  endif()
  if(TARGET PkgConfig::BULLET)
    target_link_libraries(cookbook_peers INTERFACE PkgConfig::BULLET)
    target_compile_definitions(cookbook_peers INTERFACE COOKBOOK_HAS_BULLET)
  endif()
  if(TARGET PkgConfig::FCL)
    # It asks for -std=c++11, as if nothing newer would do.
    set_target_properties(PkgConfig::FCL PROPERTIES INTERFACE_COMPILE_OPTIONS "")
    target_link_libraries(cookbook_peers INTERFACE PkgConfig::FCL)
    target_compile_definitions(cookbook_peers INTERFACE COOKBOOK_HAS_FCL)
  endif()
  find_package(embree QUIET)
  if(TARGET embree)
    target_link_libraries(cookbook_peers INTERFACE embree)
    target_compile_definitions(cookbook_peers INTERFACE COOKBOOK_HAS_EMBREE)
  endif()
  # Of its headers only; its own set-up would choose compilers' flags.
  find_path(CGAL_INCLUDE_DIR CGAL/AABB_tree.h)
  if(CGAL_INCLUDE_DIR)
    target_include_directories(cookbook_peers SYSTEM INTERFACE ${CGAL_INCLUDE_DIR})
    target_link_libraries(cookbook_peers INTERFACE mpfr gmp)
    target_compile_definitions(cookbook_peers INTERFACE COOKBOOK_HAS_CGAL)
  endif()
endif()

# cookbook_glm: vectors and matrices of another library, for the charts of chapter 1.
add_library(cookbook_glm INTERFACE)
find_path(GLM_INCLUDE_DIR glm/glm.hpp)
if(COOKBOOK_PEERS AND GLM_INCLUDE_DIR)
  target_include_directories(cookbook_glm SYSTEM INTERFACE ${GLM_INCLUDE_DIR})
  target_compile_definitions(cookbook_glm INTERFACE COOKBOOK_HAS_GLM)
endif()
