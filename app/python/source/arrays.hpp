#pragma once

#include "core/engine/base/vec2.hpp"

#include <cstddef>
#include <pybind11/numpy.h>
#include <span>
#include <string>
#include <vector>

namespace forefront::python {

namespace py = pybind11;

/// An argument that becomes a contiguous array of numbers; lists are converted.
template <class T>
using ArrayOf = py::array_t<T, py::array::c_style | py::array::forcecast>;

/// Returns a read-only array over memory that `base` keeps alive; nothing is copied. `stride`: bytes from row to row;
/// `columns`: 0 for an array of one dimension.
template <class T>
py::array viewOf(py::handle base, const T *data, std::size_t rows, std::size_t columns, std::size_t stride) {
    const auto size = [](std::size_t n) { return static_cast<py::ssize_t>(n); };
    std::vector<py::ssize_t> shape{size(rows)}, strides{size(stride)};
    if (columns > 0) {
        shape.push_back(size(columns));
        strides.push_back(size(sizeof(T)));
    }
    py::array view(py::dtype::of<T>(), shape, strides, rows == 0 ? nullptr : data, base);
    view.attr("setflags")(py::arg("write") = false);
    return view;
}

/// Returns a read-only array with a copy of values.
template <class T, class Values>
py::array copyOfValues(const Values &values) {
    py::array_t<T> copy(static_cast<py::ssize_t>(values.size()));
    T *to = copy.mutable_data();
    for (const auto &value : values) {
        *to++ = static_cast<T>(value);
    }
    copy.attr("setflags")(py::arg("write") = false);
    return copy;
}

/// Returns points as an array of shape (n, 2).
py::array pointArray(std::span<const Vec2> points);

/// Returns the points of an array of shape (n, 2). Raises ValueError for another shape. `what`: the argument.
std::vector<Vec2> pointsOf(const ArrayOf<double> &array, const std::string &what);

/// Returns the point of two numbers. Raises ValueError for anything else.
Vec2 pointOf(const py::object &pair, const std::string &what);

} // namespace forefront::python
