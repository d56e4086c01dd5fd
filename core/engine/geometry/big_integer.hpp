#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace forefront {

/// A signed integer of any size, with the operations that the predicates need where expansions overflow or underflow.
///
/// Own code instead of boost::multiprecision::cpp_int: only coordinates beyond about 1e±60 get here, where an
/// orientation takes 20 µs (cpp_int: 10 µs), while the Boost headers are a package of 138 MB, more than everything else
/// the core needs, and add 2.7 s to the compilation of the predicates. The tests compare the predicates with Boost's
/// rationals.
class BigInteger {
  public:
    BigInteger() = default;

    /// Returns value · 2^1074, which is an integer for every finite double.
    static BigInteger fromScaledDouble(double value) {
        BigInteger result;
        int exponent = 0;
        // In [0.5, 1) times 2^exponent; 53 bits make the fraction an integer.
        const double fraction = std::frexp(value, &exponent);
        auto mantissa = static_cast<std::uint64_t>(std::ldexp(std::fabs(fraction), 53));
        int shift = exponent - 53 + 1074;
        if (shift < 0) { // subnormal: the low bits are zero
            mantissa >>= -shift;
            shift = 0;
        }
        if (mantissa == 0) {
            return result;
        }
        result.negative_ = value < 0.0;
        result.limbs_.assign(static_cast<std::size_t>(shift / 32), 0U);
        const unsigned offset = static_cast<unsigned>(shift % 32);
        const auto low = static_cast<std::uint64_t>(static_cast<std::uint32_t>(mantissa)) << offset;
        const auto high = ((mantissa >> 32) << offset) + (low >> 32);
        result.limbs_.push_back(static_cast<std::uint32_t>(low));
        result.limbs_.push_back(static_cast<std::uint32_t>(high));
        result.limbs_.push_back(static_cast<std::uint32_t>(high >> 32));
        result.trim();
        return result;
    }

    int sign() const { return limbs_.empty() ? 0 : (negative_ ? -1 : 1); }

    friend BigInteger operator+(const BigInteger &a, const BigInteger &b) {
        BigInteger result;
        if (a.negative_ == b.negative_) {
            result.limbs_ = addMagnitudes(a.limbs_, b.limbs_);
            result.negative_ = a.negative_;
        } else if (lessMagnitude(a.limbs_, b.limbs_)) {
            result.limbs_ = subtractMagnitudes(b.limbs_, a.limbs_);
            result.negative_ = b.negative_;
        } else {
            result.limbs_ = subtractMagnitudes(a.limbs_, b.limbs_);
            result.negative_ = a.negative_;
        }
        result.trim();
        return result;
    }
    friend BigInteger operator-(const BigInteger &a, BigInteger b) {
        b.negative_ = !b.negative_ && !b.limbs_.empty();
        return a + b;
    }
    friend BigInteger operator*(const BigInteger &a, const BigInteger &b) {
        BigInteger result;
        result.limbs_.assign(a.limbs_.size() + b.limbs_.size(), 0U);
        for (std::size_t i = 0; i < a.limbs_.size(); ++i) {
            std::uint64_t carry = 0;
            for (std::size_t j = 0; j < b.limbs_.size(); ++j) {
                carry += result.limbs_[i + j] + static_cast<std::uint64_t>(a.limbs_[i]) * b.limbs_[j];
                result.limbs_[i + j] = static_cast<std::uint32_t>(carry);
                carry >>= 32;
            }
            result.limbs_[i + b.limbs_.size()] = static_cast<std::uint32_t>(carry);
        }
        result.negative_ = a.negative_ != b.negative_;
        result.trim();
        return result;
    }

  private:
    using Limbs = std::vector<std::uint32_t>; // least significant first, no leading zeros

    void trim() {
        while (!limbs_.empty() && limbs_.back() == 0U) {
            limbs_.pop_back();
        }
        negative_ = negative_ && !limbs_.empty();
    }
    static bool lessMagnitude(const Limbs &a, const Limbs &b) {
        if (a.size() != b.size()) {
            return a.size() < b.size();
        }
        for (std::size_t i = a.size(); i-- > 0;) {
            if (a[i] != b[i]) {
                return a[i] < b[i];
            }
        }
        return false;
    }
    static Limbs addMagnitudes(const Limbs &a, const Limbs &b) {
        const Limbs &longer = a.size() < b.size() ? b : a;
        const Limbs &shorter = a.size() < b.size() ? a : b;
        Limbs result = longer;
        std::uint64_t carry = 0;
        for (std::size_t i = 0; i < longer.size(); ++i) {
            carry += static_cast<std::uint64_t>(longer[i]) + (i < shorter.size() ? shorter[i] : 0U);
            result[i] = static_cast<std::uint32_t>(carry);
            carry >>= 32;
        }
        result.push_back(static_cast<std::uint32_t>(carry));
        return result;
    }
    /// Requires a >= b.
    static Limbs subtractMagnitudes(const Limbs &a, const Limbs &b) {
        Limbs result = a;
        std::int64_t borrow = 0;
        for (std::size_t i = 0; i < a.size(); ++i) {
            std::int64_t digit = static_cast<std::int64_t>(a[i]) - (i < b.size() ? b[i] : 0U) - borrow;
            borrow = digit < 0 ? 1 : 0;
            digit += borrow << 32;
            result[i] = static_cast<std::uint32_t>(digit);
        }
        return result;
    }

    Limbs limbs_;
    bool negative_ = false;
};

} // namespace forefront
