/// \file
/// What WebAssembly has no library for: an exception ends the program, with what it says.

#include <cstdio>
#include <cstdlib>
#include <exception>

extern "C"
{
  void* __cxa_allocate_exception(std::size_t size)
  {
    return std::malloc(size);
  }

  [[noreturn]] void __cxa_throw(void* thrown, void*, void (*)(void*))
  {
    std::fprintf(stderr, "%s\n", static_cast<std::exception*>(thrown)->what());
    std::abort();
  }
}
