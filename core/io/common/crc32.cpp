#include "core/io/common/crc32.hpp"

#include <array>

namespace forefront {

std::uint32_t crc32(std::string_view bytes) {
    static const std::array<std::uint32_t, 256> table = [] {
        std::array<std::uint32_t, 256> made{};
        for (std::uint32_t k = 0; k < 256; ++k) {
            std::uint32_t value = k;
            for (int bit = 0; bit < 8; ++bit) {
                value = (value & 1U) != 0 ? 0xEDB88320U ^ value >> 1 : value >> 1;
            }
            made[k] = value;
        }
        return made;
    }();
    std::uint32_t sum = 0xFFFFFFFFU;
    for (const char byte : bytes) {
        sum = table[(sum ^ static_cast<std::uint8_t>(byte)) & 0xFFU] ^ sum >> 8;
    }
    return ~sum;
}

} // namespace forefront
