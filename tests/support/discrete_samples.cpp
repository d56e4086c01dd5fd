#include "tests/support/discrete_samples.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace forefront::testing {

namespace {

class LambdaSpacing final : public SpacingField {
  public:
    explicit LambdaSpacing(std::function<double(Vec2)> rho) : rho_(std::move(rho)) {}
    double at(Vec2 p) const override { return rho_(p); }
    void atMany(std::span<const Vec2> points, std::span<double> rho) const override {
        std::transform(points.begin(), points.end(), rho.begin(), rho_);
    }
    SpacingSample sample(Vec2 p) const override { return {rho_(p), SpacingOrigin::Expression, 0, "test"}; }
    double minimum() const override { return 0.0; }
    double maximum() const override { return 1e300; }

  private:
    std::function<double(Vec2)> rho_;
};

} // namespace

std::shared_ptr<const SpacingField> spacingOf(std::function<double(Vec2)> rho) {
    return std::make_shared<LambdaSpacing>(std::move(rho));
}

std::uint32_t DiscreteBuilder::node(Vec2 p) {
    const auto found = std::find(domain_.nodes.begin(), domain_.nodes.end(), p);
    if (found != domain_.nodes.end()) {
        return static_cast<std::uint32_t>(found - domain_.nodes.begin());
    }
    domain_.nodes.push_back(p);
    return static_cast<std::uint32_t>(domain_.nodes.size() - 1);
}

DiscreteBuilder &DiscreteBuilder::loop(const std::vector<Vec2> &nodes, std::uint32_t left, std::uint32_t right) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        domain_.segments.push_back({node(nodes[i]), node(nodes[(i + 1) % nodes.size()]), 1, left, right, 0});
    }
    return *this;
}

DiscreteBuilder &DiscreteBuilder::chain(const std::vector<Vec2> &nodes) {
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
        domain_.segments.push_back({node(nodes[i]), node(nodes[i + 1]), 2, 0, 0, 0});
    }
    return *this;
}

DiscreteBuilder &DiscreteBuilder::point(Vec2 p) {
    domain_.points.push_back({node(p), 3});
    return *this;
}

DiscreteBuilder &DiscreteBuilder::region(std::int32_t tag, double area) {
    domain_.regions.push_back({tag, area});
    return *this;
}

std::vector<Vec2> circleNodes(Vec2 centre, double radius, int n, bool counterClockwise) {
    std::vector<Vec2> nodes;
    for (int i = 0; i < n; ++i) {
        const double angle = 2.0 * std::numbers::pi * (counterClockwise ? i : n - i) / n;
        nodes.push_back(centre + Vec2{radius * std::cos(angle), radius * std::sin(angle)});
    }
    return nodes;
}

std::vector<Vec2> rectangleNodes(Vec2 low, Vec2 high, double h, bool counterClockwise) {
    const Vec2 corners[] = {low, {high.x, low.y}, high, {low.x, high.y}};
    std::vector<Vec2> nodes;
    for (int k = 0; k < 4; ++k) {
        const Vec2 a = corners[k];
        const Vec2 b = corners[(k + 1) % 4];
        const int pieces = std::max(1, static_cast<int>(std::ceil(distance(a, b) / h - 1e-9)));
        for (int i = 0; i < pieces; ++i) {
            nodes.push_back(lerp(a, b, static_cast<double>(i) / pieces));
        }
    }
    if (!counterClockwise) {
        std::reverse(nodes.begin(), nodes.end());
    }
    return nodes;
}

std::shared_ptr<const DiscreteDomain> discreteDisc(double h) {
    const int n = static_cast<int>(2.0 * std::numbers::pi / h);
    const double area = 0.5 * n * std::sin(2.0 * std::numbers::pi / n);
    return DiscreteBuilder().loop(circleNodes({0, 0}, 1.0, n)).region(1, area).build();
}

std::shared_ptr<const DiscreteDomain> discretePlate(double h) {
    const int n = std::max(6, static_cast<int>(2.0 * std::numbers::pi * 0.15 / h));
    const double hole = 0.5 * n * std::sin(2.0 * std::numbers::pi / n) * 0.15 * 0.15;
    std::vector<Vec2> slit;
    for (double x = 0.15; x < 0.85; x += h) {
        slit.push_back({x, 0.8 - 0.1 * x});
    }
    return DiscreteBuilder()
        .loop(rectangleNodes({0, 0}, {1, 1}, h))
        .loop(circleNodes({0.4, 0.4}, 0.15, n, false))
        .chain(slit)
        .point({0.7, 0.3})
        .region(1, 1.0 - hole)
        .build();
}

} // namespace forefront::testing
