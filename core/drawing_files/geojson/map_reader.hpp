#pragma once

#include "core/drawing_files/common/drawing_builder.hpp"
#include "core/drawing_files/geojson/feature_names.hpp"
#include "core/files/common/domain_file.hpp"
#include "core/files/common/tag_allocator.hpp"
#include "core/files/json/json_check.hpp"

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// Places of a map in their order, and where each stands in the text.
struct MapPath {
    std::vector<Vec2> nodes;
    std::vector<std::size_t> offsets;
    std::size_t offset = 0; ///< of the path itself
};

/// The tag and name from the properties of a feature.
struct MapLabel {
    std::string name;
    std::optional<std::int32_t> tag;
    std::optional<double> size = {}; ///< of elements, > 0
    std::size_t feature = 0;         ///< its number; 0: none
};

/// Collects the features of a map in JSON and arranges them; the common part of the GeoJSON and TopoJSON readers.
class MapReader {
  public:
    explicit MapReader(const SourceText &source);

    JsonCheck &check() { return check_; }

    /// Records the layers of the file, and which of them is read.
    void setLayers(std::vector<std::string> names, std::string read);
    /// Reads the coordinate reference system that a text may name. RFC 7946 knows only longitude and latitude; in the
    /// systems of older files, coordinates are used as they are.
    void readReferenceSystem(const JsonValue &root);
    /// Looks at the properties of a feature: keeps its tag from being given to others, and finds out where names are.
    /// To be called for all features before anything is added.
    void survey(const JsonValue &feature);
    /// Reads the properties of a feature; without a number.
    MapLabel label(const JsonValue &feature);
    /// Returns the number of the next feature.
    std::size_t nextFeature() { return ++features_; }
    /// Returns "id" if ids of features are names, else nothing.
    std::string_view idMember() const { return names_.uses("id") ? "id" : ""; }
    /// Reports the members of an object that are not known and hence not used.
    void noteMembers(const JsonValue &object, std::initializer_list<std::string_view> known);
    void noteWithoutGeometry(const JsonValue &feature);

    /// Reads longitude and latitude, or x and y.
    Vec2 position(const JsonValue &value);
    /// Adds a polygon of an outline and holes, whose first node may be repeated at the end. Polygons of one feature
    /// cover it together.
    void addPolygon(std::vector<MapPath> rings, const MapLabel &label);
    void addLine(MapPath line, const MapLabel &label);
    void addPoint(Vec2 place, std::size_t offset, const MapLabel &label);

    /// Reports unused content and arranges the rest. `whole`: for a fault that concerns all.
    Result<DomainFile> finish(const JsonValue &whole);

  private:
    struct Polygon {
        std::vector<MapPath> rings; ///< outline and holes, the first node not repeated
        std::int32_t boundaryTag = 1;
        std::int32_t regionTag = 1;
        std::size_t feature = 0;
        std::string name;
        std::optional<double> size = {};
        bool evenOdd = false; ///< the rings are parts of the area and holes in any order
    };
    struct Line {
        MapPath path;
        std::int32_t tag = 1;
    };
    struct Point {
        Vec2 place;
        std::size_t offset = 0;
        std::int32_t tag = 1;
        std::optional<double> size = {};
    };
    struct Unused {
        std::set<std::string> keys;
        std::size_t first = 0, count = 0;
        void add(const std::string &key, std::size_t offset);
    };

    void requireSizes(const JsonValue &whole);
    std::optional<double> sizeIn(const JsonValue &properties);
    bool isKnown(std::string_view property) const;
    PlacedSizes sizesFor(const Domain &domain) const;
    Box2 bounds() const;
    void settleDegrees(const JsonValue &whole);
    void project(const JsonValue &whole, const Box2 &box);
    void noteOuterHoles(Polygon &polygon);
    void noteJumps() const;
    void noteUnused() const;
    void note(const Unused &unused, const char *code, const std::string &start, const std::string &end = {}) const;
    void buildPolygons();

    const SourceText &source_;
    JsonCheck check_;
    FeatureNames names_;
    bool named_ = false;    ///< a feature has a name
    bool sized_ = false;    ///< a feature has the property with its size
    bool hasSizes_ = false; ///< an area has a size
    bool planar_ = false;   ///< the coordinates are not in degrees
    TagAllocator boundaries_, regions_;
    std::vector<Polygon> polygons_;
    std::vector<Line> lines_;
    std::vector<Point> points_;
    std::vector<PartName> partNames_; ///< their places are projected with the map
    Unused properties_, members_, heights_;
    std::size_t features_ = 0; ///< numbered so far
    DrawingContents contents_;
    DrawingBuilder builder_;
};

} // namespace forefront
