#pragma once

#include <cmath>

namespace forefront {

/// The logarithm of a product of many factors in [0, 1], with few calls of log.
class LogProduct {
  public:
    void multiply(double factor) {
        constexpr double kTiny = 1e-100; // far from where precision is lost
        if (product_ < kTiny || factor < kTiny) {
            sum_ += std::log(product_);
            product_ = 1.0;
        }
        product_ *= factor;
    }
    double logarithm() const { return sum_ + std::log(product_); }

  private:
    double product_ = 1.0;
    double sum_ = 0.0;
};

} // namespace forefront
