#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "demonstrator/hand.h"
#include "page/requests.h"

namespace smile::page {

/// Maximum length of names and ids in requests [bytes].
inline constexpr std::size_t kMaxRequestText = 256;

/// Request fields: reads the fields of a request, which may contain anything. Each member throws a
/// RequestError that names the field, what was found and what was expected.
class RequestFields {
 public:
  /// `request` must outlive this.
  explicit RequestFields(const Request& request) : request_(request), fields_(request.fields) {}

  const Request& request() const { return request_; }

  bool Has(const char* name) const;
  /// Returns a text that is not empty.
  std::string Text(const char* name, std::size_t max_bytes = kMaxRequestText) const;
  std::optional<std::string> OptionalText(const char* name,
                                          std::size_t max_bytes = kMaxRequestText) const;
  /// Returns a finite number from `low` to `high`.
  double Number(const char* name, double low, double high) const;
  std::optional<double> OptionalNumber(const char* name, double low, double high) const;
  /// Returns a whole number from 0 to `high`.
  std::uint64_t Whole(const char* name, std::uint64_t high) const;
  /// Returns false if the field is missing.
  bool Flag(const char* name) const;
  /// Returns a list of words, each one of `known`.
  std::vector<std::string> Words(const char* name, std::span<const std::string_view> known) const;
  /// Returns a word, one of `known`.
  std::string Word(const char* name, std::span<const std::string_view> known) const;
  /// Returns the hand of a word, or the hands of a list of words.
  demonstrator::HandName Hand(const char* name) const;
  std::set<demonstrator::HandName> Hands(const char* name) const;
  /// Returns a list of at most `max_count` items.
  const Json& List(const char* name, std::size_t max_count) const;
  /// Returns an object.
  const Json& Object(const char* name) const;

 private:
  /// Returns nullptr if the field is missing.
  const Json* Find(const char* name) const;
  const Json& Get(const char* name, const std::string& expected) const;

  const Request& request_;
  const Json& fields_;
};

}  // namespace smile::page
