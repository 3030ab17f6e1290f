#pragma once

namespace smile {

/// Joins lambdas into one visitor for std::visit, one for each alternative of a variant.
template <class... Visitors>
struct Overloaded : Visitors... {
  using Visitors::operator()...;
};

/// C++20 needs no guide here, but some compilers and tools still do.
template <class... Visitors>
Overloaded(Visitors...) -> Overloaded<Visitors...>;

}  // namespace smile
