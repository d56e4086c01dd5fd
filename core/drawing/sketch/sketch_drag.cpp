#include "core/drawing/sketch/sketch_drag.hpp"

#include "core/drawing/sketch/part_solver.hpp"
#include "core/drawing/sketch/row_space.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace forefront {
namespace {

/// Weight of a pulled unknown beside 1 for others: the pointer is missed by at most 0.2 % of the size where it can be
/// reached.
constexpr double kPullWeight = 400.0;

double longestMove(const SketchVector &a, const SketchVector &b) {
    return a.size() > 0 ? (a - b).lpNorm<forefront_eigen::Infinity>() : 0.0;
}

} // namespace

/// One independent part of a sketch while it is dragged.
class DraggedPart {
  public:
    DraggedPart(const SketchSystem &system, std::span<const std::uint32_t> equations)
        : part_(system, equations), start_(part_.x), reference_(start_), weights_(SketchVector::Ones(start_.size())) {}

    bool pull(const SketchSystem &start, std::span<const SketchPull> pulls) {
        const SketchVector before = reference_;
        SketchVector target = start_;
        weights_.setOnes();
        given_.clear();
        bool any = false;
        for (const SketchPull &pull : pulls) {
            if (const int k = part_.indexOf(pull.unknown); k >= 0) {
                target[k] = part_.scaled(pull.value, start.kinds[pull.unknown]);
                weights_[k] = kPullWeight;
                any = any || pull.value != start.values[pull.unknown];
                given_.push_back(pull);
            }
        }
        if (!any) {
            part_.x = reference_ = start_;
            moved_ = false;
            return true;
        }
        const bool done = holdsAt(target) || moveFirmlyTo(before, target) || moveTo(before, target);
        reference_ = done ? target : before;
        moved_ = moved_ || done;
        return done;
    }

    void write(std::vector<double> &values) const {
        if (!moved_) {
            return;
        }
        part_.write(values);
        for (const SketchPull &pull : exact_) {
            values[pull.unknown] = pull.value; // scaling has rounded it
        }
    }

  private:
    /// Takes the pulled place itself if everything holds there, as where a part is moved as a whole.
    bool holdsAt(const SketchVector &target) {
        const SketchVector residuals = part_.residuals(target);
        if (residuals.lpNorm<forefront_eigen::Infinity>() > kSketchHolds) {
            return false;
        }
        part_.x = target;
        exact_ = given_;
        return true;
    }

    /// Goes to the solution nearest to the target that has the firm unknowns right there, unless it leaps.
    bool moveFirmlyTo(const SketchVector &before, const SketchVector &target) {
        std::vector<bool> firm(static_cast<std::size_t>(start_.size()), false);
        std::vector<SketchPull> given;
        for (const SketchPull &pull : given_) {
            const int k = part_.indexOf(pull.unknown);
            if (pull.firm && !isDetermined(k)) {
                firm[static_cast<std::size_t>(k)] = true;
                given.push_back(pull);
            }
        }
        const SketchVector last = part_.x;
        if (given.empty() || !projectFirm(part_, target, firm)) {
            return false;
        }
        if (longestMove(part_.x, last) > kLeap * pace(before, target)) {
            part_.x = last;
            return false;
        }
        exact_ = std::move(given);
        return true;
    }

    /// Returns true if an unknown cannot move from the start, to first order.
    bool isDetermined(int k) {
        if (!space_) {
            space_ = std::make_unique<const RowSpace>(part_.slopes(start_));
        }
        const auto [known, fresh] = determined_.try_emplace(k, false);
        if (fresh) {
            known->second = space_->split(SketchVector::Unit(start_.size(), k)).outside.norm() <= kDependent;
        }
        return known->second;
    }

    static double pace(const SketchVector &before, const SketchVector &target) {
        constexpr double kLeastStep = 0.02;
        return std::max(longestMove(before, target), kLeastStep);
    }

    /// Goes to the solution nearest to the target; in small parts of the way where the direct one fails or leaps.
    bool moveTo(const SketchVector &before, const SketchVector &target) {
        constexpr int kParts = 16;
        const SketchVector last = part_.x;
        if (project(part_, target, weights_) && longestMove(part_.x, last) <= kLeap * pace(before, target)) {
            exact_.clear();
            return true;
        }
        part_.x = last;
        bool done = false;
        for (int k = 1; k <= kParts; ++k) {
            const SketchVector on = before + (static_cast<double>(k) / kParts) * (target - before);
            done = project(part_, on, weights_);
        }
        if (done) {
            exact_.clear();
        } else {
            part_.x = last;
        }
        return done;
    }

    static constexpr double kLeap = 4.0; ///< of the step of the pointer

    ScaledPart part_;
    SketchVector start_, reference_, weights_;
    std::vector<SketchPull> given_;         ///< the pulls of this part, in the last step
    std::vector<SketchPull> exact_;         ///< those that x has exactly
    std::unique_ptr<const RowSpace> space_; ///< of the equations at the start
    std::map<int, bool> determined_;
    bool moved_ = false;
};

class SketchDrag::Parts {
  public:
    explicit Parts(SketchSystem start) : start_(std::move(start)), values_(start_.values) {
        const auto lists = independentParts(start_);
        constexpr auto kNone = static_cast<std::size_t>(-1);
        partOf_.assign(start_.values.size(), kNone);
        for (const std::vector<std::uint32_t> &list : lists) {
            for (const std::uint32_t equation : list) {
                for (const std::uint32_t unknown : start_.equations[equation].used()) {
                    partOf_[unknown] = start_.held[unknown] ? kNone : equations_.size();
                }
            }
            equations_.push_back(list);
        }
        parts_.resize(equations_.size());
    }

    bool pull(std::span<const SketchPull> pulls) {
        std::vector<bool> touched(parts_.size(), false);
        std::vector<double> values = start_.values;
        for (const SketchPull &pull : pulls) {
            const std::size_t part = partOf_[pull.unknown];
            if (part < parts_.size()) {
                touched[part] = true;
            } else if (!start_.held[pull.unknown]) {
                values[pull.unknown] = pull.value;
            }
        }
        bool all = true;
        for (std::size_t k = 0; k < parts_.size(); ++k) {
            if (touched[k]) {
                if (!parts_[k]) {
                    parts_[k].emplace(start_, equations_[k]);
                }
                all = parts_[k]->pull(start_, pulls) && all;
                parts_[k]->write(values);
            }
        }
        values_ = std::move(values);
        return all;
    }

    const std::vector<double> &values() const { return values_; }

  private:
    SketchSystem start_;
    std::vector<double> values_;
    std::vector<std::vector<std::uint32_t>> equations_; ///< of the parts
    std::vector<std::size_t> partOf_;                   ///< of each unknown
    std::vector<std::optional<DraggedPart>> parts_;     ///< made when first pulled
};

SketchDrag::SketchDrag(SketchSystem start) : parts_(std::make_unique<Parts>(std::move(start))) {}
SketchDrag::~SketchDrag() = default;
SketchDrag::SketchDrag(SketchDrag &&) noexcept = default;
SketchDrag &SketchDrag::operator=(SketchDrag &&) noexcept = default;

bool SketchDrag::pull(std::span<const SketchPull> pulls) {
    return parts_->pull(pulls);
}

const std::vector<double> &SketchDrag::values() const {
    return parts_->values();
}

} // namespace forefront
