#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "page/requests.h"

namespace smile::page {

/// No name or id in a request is longer.
inline constexpr std::size_t kMaxRequestText = 256;

/// Reads what a request says. Whoever sends it may send anything: each member throws a RequestError
/// that names the field, what was found and what was expected.
class RequestFields {
 public:
  /// `request` must outlive this.
  explicit RequestFields(const Request& request) : request_(request), fields_(request.fields) {}

  const Request& request() const { return request_; }

  bool Has(const char* name) const;
  /// Not empty.
  std::string Text(const char* name, std::size_t max_bytes = kMaxRequestText) const;
  std::optional<std::string> OptionalText(const char* name,
                                          std::size_t max_bytes = kMaxRequestText) const;
  /// Finite, from `low` to `high`.
  double Number(const char* name, double low, double high) const;
  std::optional<double> OptionalNumber(const char* name, double low, double high) const;
  /// From 0 to `high`.
  std::uint64_t Whole(const char* name, std::uint64_t high) const;
  /// False if it is not there.
  bool Flag(const char* name) const;
  /// A list of some of `known`.
  std::vector<std::string> Words(const char* name, std::span<const std::string_view> known) const;
  /// One of `known`.
  std::string Word(const char* name, std::span<const std::string_view> known) const;
  /// Of up to so many items.
  const Json& List(const char* name, std::size_t max_count) const;
  /// An object.
  const Json& Object(const char* name) const;

 private:
  /// nullptr if it is not there.
  const Json* Find(const char* name) const;
  const Json& Get(const char* name, const std::string& expected) const;

  const Request& request_;
  const Json& fields_;
};

}  // namespace smile::page
