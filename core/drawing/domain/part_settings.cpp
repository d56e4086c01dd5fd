#include "core/drawing/domain/part_settings.hpp"

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/domain/unmarked_region.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

namespace forefront {
namespace {

class PartSettings {
  public:
    PartSettings(const Document &document, MeshingJob &job) : document_(document), job_(job) {
        for (const DomainSegment &segment : job.domain.segments) {
            tags_.insert(segment.tag);
        }
        for (const MarkedRegion &marker : document.regionMarkers) {
            regions_.insert(marker.tag);
        }
    }

    void add() {
        for (const LayerSpec &layer : document_.layers) {
            keep(hasLine(layer.tag, "boundary layers of"), layer, job_.layers);
        }
        for (const PeriodicSpec &spec : document_.periodic) {
            const std::string pair = "the periodic pair " + std::to_string(spec.from) + ", " + std::to_string(spec.to);
            keep(hasLine(spec.from, pair + ":") && hasLine(spec.to, pair + ":"), spec, job_.periodic);
        }
        for (const std::int32_t crack : document_.cracks) {
            keep(hasLine(crack, "the crack of"), crack, job_.cracks);
        }
        for (const StripSpec &strip : document_.strips) {
            keep(hasLine(strip.tag, "the strip of"), strip, job_.strips);
        }
        for (const MappedSpec &mapped : document_.mapped) {
            keep(hasRegion(mapped.region, "the mapped region"), mapped, job_.mapped);
        }
        for (const RegionElements &own : document_.regionElements) {
            keep(hasRegion(own.region, "the elements of region"), own, job_.regionElements);
        }
        for (const auto &[tag, size] : document_.spacing.partSizes) {
            hasLine(tag, "the size of");
        }
        for (const auto &[tag, count] : document_.elementCounts) {
            hasLine(tag, "the number of elements of");
        }
    }

  private:
    template <class Setting>
    static void keep(bool used, const Setting &setting, std::vector<Setting> &list) {
        if (used) {
            list.push_back(setting);
        }
    }

    /// Returns true if a segment has a tag; else warns that a setting of it is left out.
    bool hasLine(std::int32_t tag, const std::string &setting) {
        if (tags_.contains(tag)) {
            return true;
        }
        warn(setting + " tag " + named(tag, document_.boundaryNames), "no segment has the tag");
        return false;
    }
    bool hasRegion(std::int32_t tag, const std::string &setting) {
        if (regions_.contains(tag)) {
            return true;
        }
        warn(setting + " " + named(tag, document_.regionNames), "no region marker has the tag");
        return false;
    }

    static std::string named(std::int32_t tag, const std::map<std::int32_t, std::string> &names) {
        const auto name = names.find(tag);
        return std::to_string(tag) + (name != names.end() ? " (" + name->second + ")" : "");
    }

    void warn(const std::string &setting, const std::string &why) {
        Diagnostic unused;
        unused.severity = Severity::Warning;
        unused.code = "unused-setting";
        unused.message = setting + ": not used, since " + why;
        unused.advice = "correct the tag, or remove the setting";
        job_.findings.push_back(std::move(unused));
    }

    const Document &document_;
    MeshingJob &job_;
    std::unordered_set<std::int32_t> tags_, regions_{kUnmarkedRegion};
};

} // namespace

void addPartSettings(const Document &document, MeshingJob &job) {
    PartSettings(document, job).add();
}

} // namespace forefront
