#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace smile {

/// List whose copies share most of it. A copy costs only the elements that were set since a list of
/// all was made; that is made again when there are too many. So a long list of which a few elements
/// change again and again is cheap to keep in every state.
template <class T>
class SharedList {
 public:
  using Numbered = std::pair<std::size_t, T>;  ///< index, element

  SharedList() : SharedList(std::vector<T>()) {}
  explicit SharedList(std::vector<T> elements)
      : all_(std::make_shared<const std::vector<T>>(std::move(elements))) {}

  std::size_t size() const { return all_->size(); }
  bool empty() const { return all_->empty(); }
  const T& operator[](std::size_t index) const {
    const auto own = std::ranges::lower_bound(own_, index, {}, &Numbered::first);
    return own != own_.end() && own->first == index ? own->second : (*all_)[index];
  }
  const T& front() const { return (*this)[0]; }
  const T& back() const { return (*this)[size() - 1]; }

  /// Sets elements.
  /// @param changes  in ascending order of their indices, which exist and differ.
  void Set(std::vector<Numbered> changes);

  bool operator==(const SharedList& other) const { return std::ranges::equal(*this, other); }

  /// Returns the indices of the elements that may differ from those of another list, in ascending
  /// order: if the two share a list of all, those that were set since, otherwise all of this list.
  std::vector<std::size_t> MayDifferFrom(const SharedList& other) const;

  /// Returns how many elements it keeps besides those that it shares with another list.
  std::size_t NumBeside(const SharedList& other) const {
    return own_.size() + (all_ == other.all_ ? 0 : size());
  }

  /// Random access, for ranges and algorithms.
  class Iterator;
  Iterator begin() const { return {this, 0}; }
  Iterator end() const { return {this, size()}; }

 private:
  /// A list of all is made again when so many elements, and a share of all, are set.
  static constexpr std::size_t kManyOwn = 16, kShare = 8;

  std::shared_ptr<const std::vector<T>> all_;
  std::vector<Numbered> own_;  ///< set since, in ascending order
};

template <class T>
void SharedList<T>::Set(std::vector<Numbered> changes) {
  std::vector<Numbered> own;
  own.reserve(own_.size() + changes.size());
  // Of two of the same index, set_union() takes that of the first range.
  std::set_union(std::make_move_iterator(changes.begin()), std::make_move_iterator(changes.end()),
                 own_.begin(), own_.end(), std::back_inserter(own),
                 [](const Numbered& a, const Numbered& b) { return a.first < b.first; });
  own_ = std::move(own);
  if (own_.size() < kManyOwn || own_.size() < size() / kShare) return;
  std::vector<T> all = *all_;
  for (Numbered& element : own_) all[element.first] = std::move(element.second);
  all_ = std::make_shared<const std::vector<T>>(std::move(all));
  own_.clear();
}

template <class T>
std::vector<std::size_t> SharedList<T>::MayDifferFrom(const SharedList& other) const {
  std::vector<std::size_t> indices;
  if (all_ != other.all_) {
    indices.resize(size());
    std::iota(indices.begin(), indices.end(), std::size_t{0});
    return indices;
  }
  for (const auto* own : {&own_, &other.own_}) {
    for (const Numbered& element : *own) indices.push_back(element.first);
  }
  std::ranges::sort(indices);
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  return indices;
}

template <class T>
class SharedList<T>::Iterator {
 public:
  using value_type = T;
  using reference = const T&;
  using pointer = const T*;
  using difference_type = std::ptrdiff_t;
  using iterator_category = std::random_access_iterator_tag;

  Iterator() = default;
  Iterator(const SharedList* list, std::size_t index) : list_(list), index_(index) {}

  reference operator*() const { return (*list_)[index_]; }
  pointer operator->() const { return &**this; }
  reference operator[](difference_type n) const { return *(*this + n); }
  Iterator& operator+=(difference_type n) {
    index_ += static_cast<std::size_t>(n);
    return *this;
  }
  Iterator& operator-=(difference_type n) { return *this += -n; }
  Iterator& operator++() { return *this += 1; }
  Iterator& operator--() { return *this -= 1; }
  Iterator operator++(int) { return std::exchange(*this, *this + 1); }
  Iterator operator--(int) { return std::exchange(*this, *this - 1); }
  friend Iterator operator+(Iterator it, difference_type n) { return it += n; }
  friend Iterator operator+(difference_type n, Iterator it) { return it += n; }
  friend Iterator operator-(Iterator it, difference_type n) { return it -= n; }
  friend difference_type operator-(const Iterator& a, const Iterator& b) {
    return static_cast<difference_type>(a.index_ - b.index_);
  }
  auto operator<=>(const Iterator& other) const { return index_ <=> other.index_; }
  bool operator==(const Iterator& other) const { return index_ == other.index_; }

 private:
  const SharedList* list_ = nullptr;
  std::size_t index_ = 0;
};

}  // namespace smile
