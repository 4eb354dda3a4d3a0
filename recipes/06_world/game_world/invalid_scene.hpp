#pragma once

/// \file
/// \brief What a scene that makes no sense is answered with.

#include <stdexcept>

namespace cookbook
{

/// What a scene with impossible numbers is answered with; it names the body, the member, what that
/// must be, and what it is.
class InvalidScene : public std::invalid_argument
{
public:
  using std::invalid_argument::invalid_argument;
};

} // namespace cookbook
