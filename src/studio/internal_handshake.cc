#include "studio/internal_handshake.h"

#include <array>
#include <bit>
#include <cstdint>

namespace smile::studio {
namespace {

constexpr std::string_view kWebSocketText = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11";
constexpr std::size_t kBlockBytes = 64;

using Sha1State = std::array<std::uint32_t, 5>;

std::uint32_t BigEndianWord(std::string_view bytes) {
  std::uint32_t word = 0;
  for (const char byte : bytes.substr(0, 4)) word = word << 8 | static_cast<std::uint8_t>(byte);
  return word;
}

/// FIPS 180-4, section 6.1.2.
void TakeBlock(std::string_view block, Sha1State* state) {
  std::array<std::uint32_t, 80> words{};
  for (std::size_t t = 0; t < 16; ++t) words[t] = BigEndianWord(block.substr(4 * t));
  for (std::size_t t = 16; t < words.size(); ++t) {
    words[t] = std::rotl(words[t - 3] ^ words[t - 8] ^ words[t - 14] ^ words[t - 16], 1);
  }
  auto [a, b, c, d, e] = *state;
  for (std::size_t t = 0; t < words.size(); ++t) {
    std::uint32_t mixed = b ^ c ^ d, constant = t < 20 ? 0x5A827999 : 0x6ED9EBA1;
    if (t < 20) mixed = (b & c) ^ (~b & d);
    if (t >= 40) constant = t < 60 ? 0x8F1BBCDC : 0xCA62C1D6;
    if (t >= 40 && t < 60) mixed = (b & c) ^ (b & d) ^ (c & d);
    const std::uint32_t sum = std::rotl(a, 5) + mixed + e + constant + words[t];
    e = d;
    d = c;
    c = std::rotl(b, 30);
    b = a;
    a = sum;
  }
  const Sha1State mixed{a, b, c, d, e};
  for (std::size_t k = 0; k < mixed.size(); ++k) (*state)[k] += mixed[k];
}

std::string Sha1Of(std::string text) {
  // Padded to whole blocks: a one bit, zeros, the number of bits (section 5.1.1).
  const std::uint64_t num_bits = 8 * text.size();
  text.push_back(static_cast<char>(0x80));
  while (text.size() % kBlockBytes != kBlockBytes - 8) text.push_back(0);
  for (int k = 7; k >= 0; --k) text.push_back(static_cast<char>((num_bits >> (8 * k)) & 0xFF));

  Sha1State state{0x67452301, 0xEFCDAB89, 0x98BADCFE, 0x10325476, 0xC3D2E1F0};
  for (std::size_t begin = 0; begin < text.size(); begin += kBlockBytes) {
    TakeBlock(std::string_view(text).substr(begin, kBlockBytes), &state);
  }
  std::string digest;
  for (const std::uint32_t word : state) {
    for (int k = 3; k >= 0; --k) digest.push_back(static_cast<char>((word >> (8 * k)) & 0xFF));
  }
  return digest;
}

/// RFC 4648, section 4.
std::string Base64Of(std::string_view bytes) {
  constexpr std::string_view kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t begin = 0; begin < bytes.size(); begin += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = begin; k < begin + 3; ++k) {
      three = three << 8 | (k < bytes.size() ? static_cast<std::uint8_t>(bytes[k]) : 0U);
    }
    for (int k = 3; k >= 0; --k) text.push_back(kLetters[(three >> (6 * k)) & 63]);
  }
  const std::size_t num_missing = (3 - bytes.size() % 3) % 3;
  return text.replace(text.size() - num_missing, num_missing, num_missing, '=');
}

}  // namespace

std::string AcceptKeyOf(std::string_view key) {
  return Base64Of(Sha1Of(std::string(key).append(kWebSocketText)));
}

}  // namespace smile::studio
