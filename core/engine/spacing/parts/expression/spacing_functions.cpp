#include "core/engine/spacing/parts/expression/spacing_functions.hpp"

#include "core/engine/geometry/polygon.hpp"
#include "core/engine/spacing/parts/expression/expression_parser.hpp"
#include "core/engine/spacing/parts/expression/expression_program.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace forefront {
namespace {

std::vector<Box2> boxesOf(const std::vector<SegmentDistance::Wall> &walls) {
    std::vector<Box2> boxes;
    boxes.reserve(walls.size());
    for (const auto &[a, b] : walls) {
        boxes.push_back(boxOf(a, b));
    }
    return boxes;
}

std::string partNames(const Domain &domain) {
    std::set<std::string> names;
    for (const DomainSegment &segment : domain.segments) {
        names.insert(boundaryName(domain.boundaryNames, segment.tag));
    }
    constexpr std::size_t kShown = 8;
    std::string list;
    std::size_t count = 0;
    for (const std::string &name : names) {
        if (count++ == kShown) {
            return list + " and others";
        }
        list += (list.empty() ? "'" : ", '") + name + "'";
    }
    return list.empty() ? "no parts" : list;
}

} // namespace

SegmentDistance::SegmentDistance(std::vector<Wall> walls) : walls_(std::move(walls)), tree_(boxesOf(walls_)) {}

double SegmentDistance::at(Vec2 p) const {
    double distance = std::numeric_limits<double>::infinity();
    tree_.nearest(p, distance, [&](std::uint32_t k) { return distanceToSegment(walls_[k].a, walls_[k].b, p); });
    return std::isfinite(distance) ? distance : 0.0;
}

ValueRange SegmentDistance::range(const Box2 &box) const {
    const double middle = at(box.centre()), reach = 0.5 * box.diagonal() * (1.0 + 1e-12);
    return {std::max(0.0, middle - reach), middle + reach, !std::isfinite(reach)};
}

SpacingFunctions::SpacingFunctions(const SpacingSpec &spec, const Domain *domain)
    : rasters_(spec.rasters), domain_(domain) {}

std::shared_ptr<const PlaneFunction> SpacingFunctions::find(std::string_view name) const {
    RasterValue value = RasterValue::Value;
    auto found = rasters_.find(name);
    if (found == rasters_.end() && (name.ends_with("_x") || name.ends_with("_y"))) {
        value = name.back() == 'x' ? RasterValue::AlongX : RasterValue::AlongY;
        found = rasters_.find(name.substr(0, name.size() - 2));
    }
    if (found == rasters_.end()) {
        return nullptr;
    }
    auto &filled = filled_[found->first];
    if (filled == nullptr) {
        filled = std::make_shared<const FilledRaster>(*found->second, found->first);
    }
    return std::make_shared<const RasterFunction>(filled, value);
}

std::string SpacingFunctions::names() const {
    std::string list;
    for (const auto &[name, raster] : rasters_) {
        list += name + ", ";
    }
    return list + "shore";
}

std::variant<std::shared_ptr<const PlaneFunction>, std::string>
SpacingFunctions::shore(std::span<const std::string> parts) const {
    std::vector<SegmentDistance::Wall> walls;
    if (domain_ == nullptr) {
        return std::make_shared<const SegmentDistance>(std::move(walls));
    }
    const std::size_t nodes = domain_->nodes.size();
    std::set<std::string, std::less<>> unknown(parts.begin(), parts.end());
    std::map<std::int32_t, bool> chosen; // by tag
    for (const DomainSegment &segment : domain_->segments) {
        if (segment.a >= nodes || segment.b >= nodes) {
            continue;
        }
        auto known = chosen.find(segment.tag);
        if (known == chosen.end()) {
            const std::string name = boundaryName(domain_->boundaryNames, segment.tag);
            known = chosen.emplace(segment.tag, std::find(parts.begin(), parts.end(), name) != parts.end()).first;
            unknown.erase(name);
        }
        if (parts.empty() ? segment.role == SegmentRole::Boundary : known->second) {
            walls.push_back({domain_->nodes[segment.a], domain_->nodes[segment.b]});
        }
    }
    if (!unknown.empty()) {
        return "unknown boundary part '" + *unknown.begin() + "'; expected " + partNames(*domain_);
    }
    return std::make_shared<const SegmentDistance>(std::move(walls));
}

std::string checkRasterName(std::string_view name) {
    const std::vector<std::string_view> names = namesIn(name);
    if (names.size() != 1 || names.front() != name) {
        return "invalid raster name '" + std::string(name) + "'; expected letters, digits and _, not a digit first";
    }
    if (isReservedName(name) || name == "shore") {
        return "raster name '" + std::string(name) + "' has another meaning in expressions; choose another name";
    }
    if (name.ends_with("_x") || name.ends_with("_y")) {
        return "raster name '" + std::string(name) +
               "' ends in _x or _y, which stands for the change of a raster along an axis; choose another name";
    }
    return {};
}

} // namespace forefront
