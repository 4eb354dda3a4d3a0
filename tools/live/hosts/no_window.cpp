#include "tools/live/hosts/controls.hpp"

#include <stdexcept>

namespace cookbook::live
{

void run_window(const std::string&, Session&)
{
  throw std::runtime_error(
      "this program was built without a window: SDL2 is not installed (./cookbook play installs "
      "it; with --terminal it is shown here)");
}

} // namespace cookbook::live
