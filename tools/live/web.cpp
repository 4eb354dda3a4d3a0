/// \file
/// \brief A live figure in a page: what the page calls, and what becomes of an error.

#include "tools/live/session.hpp"

#include <cstdint>
#include <cstdlib>
#include <exception>
#include <memory>

using cookbook::live::Session;

namespace
{

std::unique_ptr<Session> session;
std::string input, output;

} // namespace

extern "C"
{

  /// The page shows this error and starts the figure anew.
  [[noreturn]] __attribute__((import_module("env"), import_name("failed"))) void
  live_failed(const char* what);

  /// Makes room for `size` bytes of events; begins the figure with the first call.
  __attribute__((export_name("space"))) char* live_space(std::uint32_t size)
  {
    if (!session)
    {
      session = std::make_unique<Session>(cookbook::live::figure);
    }
    input.assign(size, ' ');
    return input.data();
  }

  /// Carries out the events and returns the outputs as JSON.
  __attribute__((export_name("send"))) const char* live_send()
  {
    session->send(input);
    output = session->json();
    return output.data();
  }

  /// The length of the JSON.
  __attribute__((export_name("size"))) std::uint32_t live_size()
  {
    return std::uint32_t(output.size());
  }

  /// The picture's pixels.
  __attribute__((export_name("pixels"))) const std::uint32_t* live_pixels()
  {
    return session->pixels().data();
  }

  // There are no exceptions here: one that is thrown is told to the page.

  void* __cxa_allocate_exception(std::size_t size)
  {
    return std::malloc(size);
  }

  [[noreturn]] void __cxa_throw(void* thrown, void*, void (*)(void*))
  {
    live_failed(static_cast<std::exception*>(thrown)->what());
  }

} // extern "C"
