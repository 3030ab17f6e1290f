#pragma once

namespace smile {

/// Combines lambdas into one visitor for std::visit, one for each alternative of a variant.
template <class... Visitors>
struct Overloaded : Visitors... {
  using Visitors::operator()...;
};

/// Not necessary in C++20, but some compilers and tools still need it.
template <class... Visitors>
Overloaded(Visitors...) -> Overloaded<Visitors...>;

}  // namespace smile
