#include "library/darkroom.h"

#include <stdexcept>
#include <utility>

#include "library/painter.h"

namespace smile::library {
namespace {

constexpr std::size_t kMaxOrders = 256;
constexpr std::size_t kMaxKept = 2000;
constexpr std::size_t kMaxKeptBytes = 64 << 20;

std::size_t SizeOf(const Darkroom::Picture& picture) { return picture ? picture->size() : 0; }

}  // namespace

Darkroom::Darkroom() : thread_([this] { Labor(); }) {}

Darkroom::~Darkroom() {
  {
    const std::lock_guard lock(mutex_);
    is_closing_ = true;
    orders_.clear();  // and their promises are broken
  }
  changed_.notify_all();
  thread_.join();
}

Darkroom::Picture Darkroom::Get(const std::string& key, const Paint& paint) {
  return Ask(key, paint).get();
}

std::shared_future<Darkroom::Picture> Darkroom::Ask(const std::string& key, const Paint& paint) {
  const std::lock_guard lock(mutex_);
  const auto known = pictures_.find(key);
  if (known != pictures_.end()) return known->second;
  if (is_closing_ || orders_.size() >= kMaxOrders) {
    throw std::runtime_error("too many pictures are asked for at once");
  }
  orders_.push_back({.key = key, .paint = paint});
  changed_.notify_one();
  return pictures_[key] = orders_.back().picture.get_future().share();
}

void Darkroom::Labor() {
  Painter painter;
  while (auto order = TakeOrder()) Fulfil(*std::move(order), &painter);
}

std::optional<Darkroom::Order> Darkroom::TakeOrder() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return is_closing_ || !orders_.empty(); });
  if (is_closing_) return std::nullopt;
  Order order = std::move(orders_.front());
  orders_.pop_front();
  return order;
}

void Darkroom::Fulfil(Order order, Painter* painter) {
  try {
    Picture picture = order.paint(painter);
    const std::lock_guard lock(mutex_);
    kept_.push_back(order.key);
    kept_bytes_ += SizeOf(picture);
    while (kept_.size() > kMaxKept || kept_bytes_ > kMaxKeptBytes) {
      const auto oldest = pictures_.find(kept_.front());
      // The newest is not yet promised to be there.
      if (oldest->first == order.key) break;
      kept_bytes_ -= SizeOf(oldest->second.get());
      pictures_.erase(oldest);
      kept_.pop_front();
    }
    order.picture.set_value(std::move(picture));
  } catch (...) {
    const std::lock_guard lock(mutex_);
    pictures_.erase(order.key);  // next time it may go well
    order.picture.set_exception(std::current_exception());
  }
}

}  // namespace smile::library
