#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace smile {

/// List whose copies share their values, in blocks of eight: a copy costs two pointers per block,
/// and a change copies one block. For many saved states that differ little.
///
/// Copies may be used by different threads.
template <class T>
class SharingList {
 public:
  std::size_t size() const { return size_; }
  const T& operator[](std::size_t i) const { return (*blocks_[i / kBlock])[i % kBlock]; }

  /// Sets a value. References to values become invalid.
  void Set(std::size_t i, T value) {
    std::shared_ptr<const Block>& block = blocks_[i / kBlock];
    const auto changed = std::make_shared<Block>(*block);
    (*changed)[i % kBlock] = std::move(value);
    block = changed;
  }
  /// Removes values from the end, or adds default values.
  void Resize(std::size_t size) {
    const std::size_t before = size_;
    blocks_.resize((size + kBlock - 1) / kBlock, std::make_shared<const Block>());
    size_ = size;
    // Values beyond the end of the last block become those of its next growth.
    for (std::size_t i = size; i < before && i / kBlock < blocks_.size(); ++i) Set(i, T());
  }

 private:
  static constexpr std::size_t kBlock = 8;
  using Block = std::array<T, kBlock>;

  std::vector<std::shared_ptr<const Block>> blocks_;
  std::size_t size_ = 0;
};

}  // namespace smile
