#pragma once

#include <array>
#include <cmath>

namespace forefront {

/// An exact sum of at most `Capacity` doubles: non-overlapping, by increasing magnitude, without zeros.
///
/// Algorithms and names: J. R. Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
/// Predicates, 1997. Exact as long as no partial result overflows or underflows; callers guard the range of the input.
/// The length depends on the data, so easy input is cheap.
template <int Capacity>
struct Expansion {
    std::array<double, Capacity> part;
    int size = 0;

    void append(double value) {
        if (value != 0.0) {
            part[static_cast<std::size_t>(size++)] = value;
        }
    }
    double operator[](int i) const { return part[static_cast<std::size_t>(i)]; }
    /// Returns the sign of the sum, which is that of its largest component.
    int sign() const { return size == 0 ? 0 : ((*this)[size - 1] > 0.0 ? 1 : -1); }
};

struct RoundedPair {
    double value; ///< the rounded result
    double error; ///< exact result - value
};

inline RoundedPair twoSum(double a, double b) {
    const double sum = a + b;
    const double bVirtual = sum - a;
    return {sum, (a - (sum - bVirtual)) + (b - bVirtual)};
}

/// Returns the product with its error (Dekker's product with Veltkamp's split).
inline RoundedPair twoProduct(double a, double b) {
    constexpr double kSplitter = 134217729.0; // 2^27 + 1
    const double product = a * b;
    const double aBig = kSplitter * a, bBig = kSplitter * b;
    const double aHigh = aBig - (aBig - a), bHigh = bBig - (bBig - b);
    const double aLow = a - aHigh, bLow = b - bHigh;
    const double error = ((aHigh * bHigh - product) + aHigh * bLow + aLow * bHigh) + aLow * bLow;
    return {product, error};
}

inline Expansion<2> difference(double a, double b) {
    const RoundedPair pair = twoSum(a, -b);
    Expansion<2> result;
    result.append(pair.error);
    result.append(pair.value);
    return result;
}

template <int A, int B>
Expansion<A + B> sum(const Expansion<A> &e, const Expansion<B> &f) {
    Expansion<A + B> result;
    int i = 0, j = 0;
    const auto next = [&] {
        const bool fromE = j == f.size || (i < e.size && std::fabs(e[i]) < std::fabs(f[j]));
        return fromE ? e[i++] : f[j++];
    };
    if (e.size + f.size == 0) {
        return result;
    }
    double carry = next();
    while (i < e.size || j < f.size) {
        const RoundedPair pair = twoSum(carry, next());
        result.append(pair.error);
        carry = pair.value;
    }
    result.append(carry);
    return result;
}

template <int A>
Expansion<A> negated(Expansion<A> e) {
    for (int i = 0; i < e.size; ++i) {
        e.part[static_cast<std::size_t>(i)] = -e[i];
    }
    return e;
}

template <int A>
Expansion<2 * A> scaled(const Expansion<A> &e, double factor) {
    Expansion<2 * A> result;
    if (e.size == 0) {
        return result;
    }
    RoundedPair product = twoProduct(e[0], factor);
    result.append(product.error);
    double carry = product.value;
    for (int i = 1; i < e.size; ++i) {
        product = twoProduct(e[i], factor);
        const RoundedPair low = twoSum(carry, product.error);
        result.append(low.error);
        const RoundedPair high = twoSum(product.value, low.value);
        result.append(high.error);
        carry = high.value;
    }
    result.append(carry);
    return result;
}

template <int A, int B>
Expansion<2 * A * B> product(const Expansion<A> &e, const Expansion<B> &f) {
    Expansion<2 * A * B> result;
    for (int j = 0; j < f.size; ++j) {
        const auto longer = sum(result, scaled(e, f[j]));
        result.size = longer.size;
        for (int i = 0; i < longer.size; ++i) {
            result.part[static_cast<std::size_t>(i)] = longer[i];
        }
    }
    return result;
}

} // namespace forefront
