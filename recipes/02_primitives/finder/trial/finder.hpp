#pragma once

/// \file
/// \brief Which questions about which two shapes have an answer, by the names of the shapes.

#include "tools/program/asking.hpp"

#include <optional>
#include <string>
#include <vector>

namespace cookbook
{

/// What can be asked of two shapes, as `--ask` names it.
const std::vector<std::string>& finder_asks();

/// The names of all shapes, those in space first.
const std::vector<std::string>& finder_shapes();

// [finder_question]
/// The question about two shapes, or nothing where the finder has no answer.
///
/// Instances: float and double.
template <class Real>
std::optional<Question<Real>>
finder_question(const std::string& ask, const std::string& a, const std::string& b);
// [finder_question]

/// The shapes that a question about `a` and another may name.
std::vector<std::string> finder_partners(const std::string& ask, const std::string& a);

} // namespace cookbook
