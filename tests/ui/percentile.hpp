#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace forefront::test {

/// Returns the value below which a part of the values lie, from 0 to 1; 0 if there are none.
inline double percentile(std::vector<double> values, double part) {
    if (values.empty()) {
        return 0.0;
    }
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

} // namespace forefront::test
