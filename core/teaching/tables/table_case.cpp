#include "core/teaching/tables/table_case.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <string>

namespace forefront {

namespace {

constexpr std::array<TableCase, 12> kCases = {{{"1A", 0.1},
                                               {"1B", 0.05},
                                               {"1C", 0.02},
                                               {"1D", 0.01},
                                               {"1E", 0.005},
                                               {"2A", 0.1},
                                               {"2B", 0.05},
                                               {"2C", 0.02},
                                               {"2D", 0.01},
                                               {"2E", 0.005},
                                               {"3", 0.05, true},
                                               {"4", 0.03, true}}};

/// [0,90]x[0,60], counter-clockwise, in segments of length 6.
Domain rectangle() {
    constexpr double kStep = 6.0;
    constexpr int kColumns = 15, kRows = 10;
    Domain domain;
    const auto side = [&](Vec2 from, Vec2 step, int count) {
        for (int i = 0; i < count; ++i) {
            domain.nodes.push_back(from + static_cast<double>(i) * step);
        }
    };
    side({0.0, 0.0}, {kStep, 0.0}, kColumns);
    side({kColumns * kStep, 0.0}, {0.0, kStep}, kRows);
    side({kColumns * kStep, kRows * kStep}, {-kStep, 0.0}, kColumns);
    side({0.0, kRows * kStep}, {0.0, -kStep}, kRows);
    const auto count = static_cast<std::uint32_t>(domain.nodes.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        domain.segments.push_back({i, (i + 1) % count, 1, SegmentRole::Boundary});
    }
    return domain;
}

std::string spacingExpression(const TableCase &row) {
    char text[160];
    if (row.row.front() == '1') {
        std::snprintf(text, sizeof text, "max(%g, 0.303*abs(dist(45,30)-16))", row.rhoMin);
    } else {
        std::snprintf(text, sizeof text, "max(%g, 0.298*min(abs(dist(22.5,30)-12), abs(dist(67.5,30)-12)))",
                      row.rhoMin);
    }
    return text;
}

} // namespace

std::span<const TableCase> tableCases() {
    return kCases;
}

const TableCase *tableCase(std::string_view row) {
    const auto same = [](char a, char b) { return std::toupper(static_cast<unsigned char>(a)) == b; };
    const auto found = std::find_if(kCases.begin(), kCases.end(), [&](const TableCase &c) {
        const std::string_view name = c.adaptive && row.ends_with('*') ? row.substr(0, row.size() - 1) : row;
        return std::equal(name.begin(), name.end(), c.row.begin(), c.row.end(), same);
    });
    return found == kCases.end() ? nullptr : &*found;
}

MeshingJob tableJob(const TableCase &row) {
    MeshingJob job;
    job.options.keepBoundary = true;
    job.options.method = Method::Classic;
    job.options.improve = ImproveLevel::None;
    job.domain = rectangle();
    job.spacing.expression = spacingExpression(row);
    return job;
}

} // namespace forefront
