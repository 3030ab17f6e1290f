#pragma once

namespace smile {

/// Joins lambdas into one visitor for std::visit, one for each alternative of a variant.
template <class... Visitors>
struct Overloaded : Visitors... {
  using Visitors::operator()...;
};

}  // namespace smile
