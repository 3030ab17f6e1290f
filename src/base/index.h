#pragma once

#include <compare>
#include <cstddef>
#include <iterator>

namespace smile {

/// Index into a list, with a type of its own for each kind of list, so that the index of an object
/// cannot be passed for that of a control. Conversion from a number is explicit; conversion to one
/// is implicit. After Drake's TypeSafeIndex.
template <class Tag>
class Index {
 public:
  constexpr explicit Index(std::size_t value) : value_(value) {}
  template <class OtherTag>
  Index(Index<OtherTag>) = delete;

  constexpr operator std::size_t() const { return value_; }
  constexpr Index& operator++() {
    ++value_;
    return *this;
  }

  friend constexpr bool operator==(Index, Index) = default;
  friend constexpr auto operator<=>(Index, Index) = default;
  template <class OtherTag>
  bool operator==(Index<OtherTag>) const = delete;

 private:
  std::size_t value_;
};

/// Consecutive indices from `first` up to, but not including, `last`; for range-based loops.
template <class I>
class IndexRange {
 public:
  class Iterator {
   public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = I;
    using difference_type = std::ptrdiff_t;
    using pointer = const I*;
    using reference = I;

    explicit Iterator(I index) : index_(index) {}
    I operator*() const { return index_; }
    Iterator& operator++() {
      ++index_;
      return *this;
    }
    Iterator operator++(int) {
      const Iterator before = *this;
      ++index_;
      return before;
    }
    bool operator==(const Iterator&) const = default;

   private:
    I index_;
  };

  IndexRange(I first, I last) : first_(first), last_(last) {}
  /// Makes the range of all indices of a list of this size.
  explicit IndexRange(std::size_t size) : IndexRange(I(0), I(size)) {}

  Iterator begin() const { return Iterator(first_); }
  Iterator end() const { return Iterator(last_); }
  std::size_t size() const { return last_ - first_; }
  bool contains(I index) const { return first_ <= index && index < last_; }

 private:
  I first_, last_;
};

}  // namespace smile
