# cookbook_test_main: Catch2, of version 2 or 3, and the main program of every test.

add_library(cookbook_test_main INTERFACE)
target_include_directories(cookbook_test_main INTERFACE ${PROJECT_SOURCE_DIR})
if(Catch2_VERSION VERSION_GREATER_EQUAL 3)
  target_link_libraries(cookbook_test_main INTERFACE Catch2::Catch2WithMain)
else()
  add_library(cookbook_catch_main STATIC ${PROJECT_SOURCE_DIR}/tests/catch_main.cpp)
  target_link_libraries(cookbook_catch_main PUBLIC Catch2::Catch2)
  cookbook_lightly(cookbook_catch_main)
  target_link_libraries(cookbook_test_main INTERFACE cookbook_catch_main)
endif()

cookbook_precompiled(cookbook_test_headers ${PROJECT_SOURCE_DIR}/tests/precompiled.hpp
  cookbook_common cookbook_exact cookbook_tools cookbook_test_main)
cookbook_lightly(cookbook_test_headers -O1)
