#include "app/python/source/arrays.hpp"

namespace forefront::python {

py::array pointArray(std::span<const Vec2> points) {
    py::array_t<double> array({static_cast<py::ssize_t>(points.size()), py::ssize_t{2}});
    double *to = array.mutable_data();
    for (const Vec2 p : points) {
        *to++ = p.x;
        *to++ = p.y;
    }
    return array;
}

std::vector<Vec2> pointsOf(const ArrayOf<double> &array, const std::string &what) {
    if (array.size() == 0) {
        return {};
    }
    if (array.ndim() != 2 || array.shape(1) != 2) {
        throw py::value_error(what + ": expected an array of shape (n, 2)");
    }
    std::vector<Vec2> points(static_cast<std::size_t>(array.shape(0)));
    const double *from = array.data();
    for (Vec2 &point : points) {
        point = {from[0], from[1]};
        from += 2;
    }
    return points;
}

Vec2 pointOf(const py::object &pair, const std::string &what) {
    const auto array = ArrayOf<double>::ensure(pair);
    if (!array) {
        PyErr_Clear();
    }
    if (!array || array.ndim() != 1 || array.size() != 2) {
        throw py::value_error(what + ": expected two numbers (x, y)");
    }
    return {array.data()[0], array.data()[1]};
}

} // namespace forefront::python
