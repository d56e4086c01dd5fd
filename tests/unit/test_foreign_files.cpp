#include "core/drawing_files/drawing_formats.hpp"
#include "core/files/files.hpp"
#include "core/files/foreign_files.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <array>
#include <fstream>
#include <string>

using namespace forefront;
using namespace forefront::testing;
using namespace std::string_literals;

TEST_CASE("Foreign files: kinds that cannot be read are named, with a way to convert them") {
    const struct {
        std::string bytes, name, advice;
    } cases[] = {
        {"SQLite format 3\0"s, "database", "ogr2ogr"},
        {"PK\x03\x04\x14", "ZIP", "unzip"},
        {"%PDF-1.7\n", "PDF", "pdftocairo"},
        {"%!PS-Adobe-3.0 EPSF-3.0\n", "PostScript", "SVG"},
        {"AC1027\0"s, "DWG", "DXF"},
        {"\xff\xd8\xff\xe0", "JPEG", "trace"},
        {"<ogr:FeatureCollection xmlns:gml=\"x\">", "GML", "ogr2ogr"},
        {"AutoCAD Binary DXF\r\n\x1a\0"s, "binary DXF", "ASCII"},
        {"Point(1)={0,0,0,.1};\n", "geometry of Gmsh", "gmsh -2"},
        {"// a plate\nlc = 0.1;\nPoint (1) = {0, 0, 0, lc};\nLine(1) = {1, 2};\n", "geometry of Gmsh", "gmsh -2"},
        {"SetFactory(\"OpenCASCADE\");\nCurve Loop(1) = {1:4};\n", "geometry of Gmsh", "gmsh -2"},
        {"\xff\xfe{\0\"\0"s, "UTF-16", "UTF-8"},
        {"\xfe\xff\0{\0\"\0t"s, "UTF-16", "UTF-8"},
        {"4\0 \0002\0 \0000\0 \0000\0\n\0"s, "UTF-16", "UTF-8"},
        {"\0004\0 \0002\0 \0000\0 \0000\0\n"s, "UTF-16", "UTF-8"},
        {"<!DOCTYPE html>\n<HTML lang=\"en\"><body><svg/></body></HTML>", "web page", "map itself"},
        {"<gpx version=\"1.1\"/>", "GPX", "ogr2ogr"},
        {"\xef\xbb\xbf<gml:FeatureCollection>", "GML", "ogr2ogr"},
    };
    const TemporaryFolder folder;
    for (const auto &[bytes, name, advice] : cases) {
        CAPTURE(name);
        for (const char *file : {"a.svg", "a.json", "a.geojson", "a.other"}) {
            std::ofstream(folder / file, std::ios::binary) << bytes;
            const auto domain = allFormats().readDomain(folder / file);
            REQUIRE(hasCode(domain.faults(), "foreign-format"));
            CHECK(domain.faults()[0].message.find(name) != std::string::npos);
            CHECK(domain.faults()[0].advice.find(advice) != std::string::npos);
            CHECK(domain.faults()[0].file == (folder / file).string());
        }
    }
}

TEST_CASE("Foreign files: maps that only the drawing library reads are foreign to the engine") {
    const std::string kml = "<?xml version=\"1.0\"?>\n<!-- <svg> -->\n<kml xmlns=\"x\"><Document/></kml>";
    const TemporaryFolder folder;
    for (const auto &[bytes, name, id] :
         {std::array{"\0\0\x27\x0a\0\0\0\0"s, "shapefile"s, "shapefile"s}, std::array{kml, "KML"s, "kml"s}}) {
        CAPTURE(name);
        std::ofstream(folder / "a.other", std::ios::binary) << bytes;
        const auto domain = readDomain(folder / "a.other");
        REQUIRE(hasCode(domain.faults(), "foreign-format"));
        CHECK(domain.faults()[0].message.find(name) != std::string::npos);
        REQUIRE(allFormats().detect(folder / "a.other") != nullptr);
        CHECK(allFormats().detect(folder / "a.other")->id == id);
    }
    const std::string geoPackage = "SQLite format 3\0"s + std::string(52, '\0') + "GPKG";
    REQUIRE(allFormats().detect("a", geoPackage) != nullptr);
    CHECK(allFormats().detect("a", geoPackage)->id == "gpkg"s);
    CHECK(allFormats().detect("a", "<!-- <kml> --><svg/>")->id == "svg"s);
}

TEST_CASE("Foreign files: all that can be read, and fragments of what cannot, are left to the readers") {
    for (const std::string &bytes : {""s,
                                     " "s,
                                     "<"s,
                                     "<!--"s,
                                     "<!-- never closed <html>"s,
                                     "<?"s,
                                     "{\"type\""s,
                                     "{\"type\":"s,
                                     "0"s,
                                     "0\n"s,
                                     "point"s,
                                     "999"s,
                                     "999\n"s,
                                     "999 2 0 0\n1 0 0\n"s,
                                     "# Point(1) = {\n"s,
                                     "4 2 0 0\n"s,
                                     "polygonal (1)"s,
                                     "<svg xmlns=\"x\"><foreignObject><html/></foreignObject></svg>"s,
                                     "{\"format\": \"forefront\", \"version\": 2, \"name\": \"Topology\"}"s,
                                     "{\"type\": \"FeatureCollection\"}"s,
                                     "4 2 0 0\n1 0 0\n"s,
                                     "$MeshFormat\n2.2 0 8\n"s,
                                     "<VTKFile type=\"UnstructuredGrid\">"s,
                                     "\x89PNG\r\n"s,
                                     "<?note <html> ?><svg/>"s,
                                     "% PDF"s,
                                     "%PDF export by a solver\nNDIME= 2\n"s,
                                     "point cloud outline\nv 0 0 0\n"s,
                                     "{\"properties\": {\"type\": \"Topology\"}, \"type\": \"Feature\"}"s}) {
        CAPTURE(bytes);
        CHECK(foreignFile(bytes).empty());
    }
}

TEST_CASE("Foreign files: a format that is given explicitly is tried") {
    const TemporaryFolder folder;
    std::ofstream(folder / "a.html") << "<html><svg/></html>";
    ImportOptions options;
    options.formatId = "svg";
    CHECK(hasCode(allFormats().readDomain(folder / "a.html", options).faults(), "not-svg"));
}
