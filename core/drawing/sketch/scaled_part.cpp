#include "core/drawing/sketch/scaled_part.hpp"

#include <algorithm>
#include <cmath>

namespace forefront {
namespace {

void sortUnique(std::vector<std::uint32_t> &list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
}

int placeIn(const std::vector<std::uint32_t> &list, std::uint32_t value) {
    const auto found = std::lower_bound(list.begin(), list.end(), value);
    return found != list.end() && *found == value ? static_cast<int>(found - list.begin()) : -1;
}

/// The extent of coordinates along one axis.
struct AxisExtent {
    double low = 0.0, high = 0.0;
    bool any = false;

    void add(double value) {
        low = any ? std::min(low, value) : value;
        high = any ? std::max(high, value) : value;
        any = true;
    }
};

} // namespace

ScaledPart::ScaledPart(const SketchSystem &system, std::span<const std::uint32_t> equations) {
    equations_.reserve(equations.size());
    for (const std::uint32_t k : equations) {
        equations_.push_back(system.equations[k]);
    }
    collectUnknowns(system);
    setScale(system);
    x.resize(static_cast<int>(unknowns_.size()));
    for (std::size_t k = 0; k < unknowns_.size(); ++k) {
        kinds_.push_back(system.kinds[unknowns_[k]]);
        x[static_cast<int>(k)] = scaled(system.values[unknowns_[k]], kinds_[k]);
    }
    for (const std::uint32_t unknown : constantUnknowns_) {
        constants_.push_back(scaled(system.values[unknown], system.kinds[unknown]));
    }
    for (SketchEquation &equation : equations_) {
        if (equation.kind == EquationKind::Value) {
            equation.value = scaled(equation.value, system.kinds[equation.unknowns[0]]);
        } else if (hasLength(equation.kind)) {
            equation.value /= size_;
        }
        for (std::uint32_t &unknown : std::span(equation.unknowns).first(unknownCount(equation.kind))) {
            const int free = placeIn(unknowns_, unknown);
            unknown = static_cast<std::uint32_t>(
                free >= 0 ? free : static_cast<int>(unknowns_.size()) + placeIn(constantUnknowns_, unknown));
        }
    }
}

void ScaledPart::collectUnknowns(const SketchSystem &system) {
    for (const SketchEquation &equation : equations_) {
        for (const std::uint32_t unknown : equation.used()) {
            (system.held[unknown] ? constantUnknowns_ : unknowns_).push_back(unknown);
        }
    }
    sortUnique(unknowns_);
    sortUnique(constantUnknowns_);
}

void ScaledPart::setScale(const SketchSystem &system) {
    AxisExtent across, up;
    double longest = 0.0;
    for (const std::vector<std::uint32_t> *list : {&unknowns_, &constantUnknowns_}) {
        for (const std::uint32_t unknown : *list) {
            const double value = system.values[unknown];
            switch (system.kinds[unknown]) {
            case UnknownKind::X:
                across.add(value);
                break;
            case UnknownKind::Y:
                up.add(value);
                break;
            case UnknownKind::Length:
            case UnknownKind::Offset:
                longest = std::max(longest, std::fabs(value));
                break;
            case UnknownKind::Parameter:
                break;
            }
        }
    }
    for (const SketchEquation &equation : equations_) {
        if (hasLength(equation.kind) && equation.kind != EquationKind::Value) {
            longest = std::max(longest, std::fabs(equation.value));
        }
    }
    size_ = std::max({across.high - across.low, up.high - up.low, longest});
    size_ = size_ > 0.0 && std::isfinite(size_) ? size_ : 1.0;
    centre_ = {0.5 * (across.low + across.high), 0.5 * (up.low + up.high)};
}

int ScaledPart::indexOf(std::uint32_t unknown) const {
    return placeIn(unknowns_, unknown);
}

double ScaledPart::scaled(double value, UnknownKind kind) const {
    switch (kind) {
    case UnknownKind::X:
        return (value - centre_.x) / size_;
    case UnknownKind::Y:
        return (value - centre_.y) / size_;
    case UnknownKind::Parameter:
        return value;
    default:
        return value / size_;
    }
}

void ScaledPart::write(std::vector<double> &values) const {
    for (std::size_t k = 0; k < unknowns_.size(); ++k) {
        const double value = x[static_cast<int>(k)];
        const double length = kinds_[k] == UnknownKind::Parameter ? value : size_ * value;
        values[unknowns_[k]] = kinds_[k] == UnknownKind::X   ? centre_.x + length
                               : kinds_[k] == UnknownKind::Y ? centre_.y + length
                                                             : length;
    }
}

namespace {

/// Collects the values of the unknowns of an equation.
struct LocalValues {
    std::array<double, kEquationUnknowns> values{};

    LocalValues(const SketchEquation &equation, const SketchVector &place, const std::vector<double> &constants) {
        const auto free = static_cast<std::uint32_t>(place.size());
        std::size_t k = 0;
        for (const std::uint32_t slot : equation.used()) {
            values[k++] = slot < free ? place[static_cast<int>(slot)] : constants[slot - free];
        }
    }
};

} // namespace

SketchVector ScaledPart::residuals(const SketchVector &place) const {
    SketchVector residuals(static_cast<int>(equations_.size()));
    for (std::size_t row = 0; row < equations_.size(); ++row) {
        const LocalValues local(equations_[row], place, constants_);
        residuals[static_cast<int>(row)] = residualOf(equations_[row], local.values.data(), nullptr);
    }
    return residuals;
}

SketchRows ScaledPart::slopes(const SketchVector &place) const {
    std::vector<forefront_eigen::Triplet<double>> entries;
    entries.reserve(6 * equations_.size());
    const auto free = static_cast<std::uint32_t>(place.size());
    for (std::size_t row = 0; row < equations_.size(); ++row) {
        const LocalValues local(equations_[row], place, constants_);
        std::array<double, kEquationUnknowns> slopes{};
        residualOf(equations_[row], local.values.data(), slopes.data());
        std::size_t k = 0;
        for (const std::uint32_t slot : equations_[row].used()) {
            if (slot < free) {
                entries.emplace_back(static_cast<int>(row), static_cast<int>(slot), slopes[k]);
            }
            ++k;
        }
    }
    SketchRows matrix(static_cast<int>(equations_.size()), static_cast<int>(free));
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

bool ScaledPart::sound() const {
    constexpr double kVanished = 1e-8; // in sizes of the part
    const auto line = [](const double *v, std::size_t k) {
        return distance({v[k], v[k + 1]}, {v[k + 2], v[k + 3]}) > kVanished;
    };
    return std::all_of(equations_.begin(), equations_.end(), [&](const SketchEquation &equation) {
        const LocalValues local(equation, x, constants_);
        const double *const v = local.values.data();
        switch (equation.kind) {
        case EquationKind::Angle:
            return line(v, 0) && line(v, 4);
        case EquationKind::PointLine:
            return line(v, 2);
        case EquationKind::TangentLine:
            return line(v, 2) && v[6] > kVanished;
        case EquationKind::OnCircle:
            return v[4] > kVanished;
        case EquationKind::TangentCircles:
            return v[4] > kVanished && v[5] > kVanished;
        case EquationKind::MirrorAcross:
        case EquationKind::MirrorAlong:
            return line(v, 4);
        case EquationKind::TangentEllipse:
            return line(v, 0);
        default:
            return true;
        }
    });
}

bool ScaledPart::place(const SketchCorner &corner, Guard &guard) const {
    const std::array<std::uint32_t, 6> unknowns = {corner.a.x, corner.a.y, corner.b.x,
                                                   corner.b.y, corner.c.x, corner.c.y};
    bool moves = false;
    for (std::size_t k = 0; k < unknowns.size(); ++k) {
        const int free = indexOf(unknowns[k]);
        const int constant = placeIn(constantUnknowns_, unknowns[k]);
        if (free < 0 && constant < 0) {
            return false;
        }
        moves = moves || free >= 0;
        guard.place[k] = free >= 0 ? free : -1 - constant;
    }
    return moves;
}

double ScaledPart::turn(const Guard &guard, const SketchVector &place) const {
    std::array<double, 6> v{};
    for (std::size_t k = 0; k < v.size(); ++k) {
        v[k] = guard.place[k] >= 0 ? place[guard.place[k]] : constants_[static_cast<std::size_t>(-1 - guard.place[k])];
    }
    return turnAt({v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]});
}

SketchVector ScaledPart::roomOf(const SketchSystem &system, double share, double most, double least) const {
    SketchVector room = SketchVector::Constant(x.size(), most);
    const auto limit = [&](std::uint32_t unknown, double length) {
        if (const int k = indexOf(unknown); k >= 0) {
            room[k] = std::min(room[k], std::max(share * length / size_, least));
        }
    };
    for (const auto &[a, b] : system.edges) {
        const double length = distance(system.place(a), system.place(b));
        for (const std::uint32_t unknown : {a.x, a.y, b.x, b.y}) {
            limit(unknown, length);
        }
    }
    for (const auto &[centre, radius] : system.circles) {
        for (const std::uint32_t unknown : {centre.x, centre.y, radius}) {
            limit(unknown, system.values[radius]);
        }
    }
    return room;
}

SketchVector ScaledPart::localWeights(const SketchSystem &system) const {
    constexpr double kLeast = 0.02;
    return roomOf(system, 1.0, 1.0, kLeast).cwiseAbs2().cwiseInverse();
}

void ScaledPart::guard(const SketchSystem &system, double least, double share) {
    constexpr double kStep = 0.3, kLeastRoom = 0.01; // in sizes of the part
    guards_.clear();
    room_ = roomOf(system, share, kStep, kLeastRoom);
    for (const SketchCorner &corner : system.corners) {
        Guard guard;
        if (place(corner, guard)) {
            const double sine = turn(guard, x);
            guard.side = sine > 0.0 ? 1.0 : -1.0;
            if (std::fabs(sine) >= least) {
                guards_.push_back(guard);
            }
        }
    }
}

bool ScaledPart::keepsCorners(const SketchVector &place) const {
    return std::all_of(guards_.begin(), guards_.end(),
                       [&](const Guard &guard) { return turn(guard, place) * guard.side > 0.0; });
}

double ScaledPart::allowedShare(const SketchVector &step) const {
    double share = 1.0;
    for (int k = 0; k < room_.size(); ++k) {
        const double size = std::fabs(step[k]);
        share = share * size > room_[k] ? room_[k] / size : share;
    }
    return share;
}

} // namespace forefront
