#include "tools/live/hosts.hpp"

#include <stdexcept>

namespace cookbook::live
{

void run_host(const std::string& host, const std::string&, Session&)
{
  throw std::runtime_error("there is no " + host + " in this program");
}

} // namespace cookbook::live
