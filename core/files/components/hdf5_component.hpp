#pragma once

#include "core/engine/base/result.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace forefront {

/// The type of the numbers of an array of an HDF5 file that is written.
enum class Hdf5Number : std::uint8_t { Int32, Int64, Real64 };

/// An array of an HDF5 file that is written.
struct Hdf5Array {
    std::string path; ///< "/Mesh/mesh/geometry"; groups are made as needed
    Hdf5Number type = Hdf5Number::Real64;
    std::vector<std::uint64_t> dimensions;
    const void *values = nullptr; ///< as many as the product of the dimensions
};

/// An array of numbers of any type as read.
struct Hdf5Values {
    std::vector<std::uint64_t> dimensions;
    std::vector<double> values; ///< whole numbers are exact up to 2^53
};

/// The functions of the component that reads and writes HDF5 files. They return false with a message on failure.
struct Hdf5Functions {
    /// Makes the bytes of a file: the same for the same arrays.
    bool (*write)(const std::vector<Hdf5Array> &arrays, std::string &bytes, std::string &message);
    /// Reads an array. Refuses one with more than `maximum` numbers before any memory is taken for it.
    bool (*read)(const std::string &file, const std::string &path, std::uint64_t maximum, Hdf5Values &values,
                 std::string &message);
};

/// Returns the component, which is loaded once. Fault: missing-component.
Result<const Hdf5Functions *> hdf5Component();

} // namespace forefront
