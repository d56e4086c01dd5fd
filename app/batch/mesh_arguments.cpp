#include "app/batch/mesh_arguments.hpp"

#include "app/batch/cli_options.hpp"
#include "app/batch/crack_option.hpp"
#include "app/batch/fix_option.hpp"
#include "app/batch/form_options.hpp"
#include "app/batch/inputs.hpp"
#include "app/batch/mapped_option.hpp"
#include "app/batch/option_table.hpp"
#include "app/batch/outputs.hpp"
#include "app/batch/periodic_option.hpp"
#include "app/batch/raster_option.hpp"
#include "app/batch/rules_option.hpp"
#include "app/batch/several_inputs.hpp"
#include "app/batch/suggestion.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

namespace forefront {

namespace {

constexpr const char *kMeshExamples = R"help(
Examples:
  forefront mesh lake.geojson -o lake.msh
        automatic spacing; Gmsh MSH 2.2
  forefront mesh plate.poly -o plate.inp -o plate.svg --size 0.5
        edges of length 0.5; Abaqus input and a drawing
  forefront mesh plate.poly -o plate.msh --format msh41 --spacing "max(0.05, 0.2*sqrt(x*x+y*y))"
        edges that grow with the distance to the origin; Gmsh MSH 4.1
  forefront mesh plate.poly -o plate.msh --target-elements 5000
        about 5000 triangles, graded as the automatic spacing is
  forefront mesh plate.poly -o plate.msh --size-from-boundary --gradation 0.7 --min-angle 30
        as few triangles as the given segments and angles of 30 degrees allow, about as many as Triangle makes
  forefront mesh coast.svg -o coast.vtu --repair --stats coast.json
        splits crossing lines first; statistics as JSON
  forefront mesh lake.geojson -o lake.msh --spacing-file depth.png --picture-sizes 5:200
        edges of length 5 where the picture is black, 200 where it is white
  forefront mesh plate.poly -o plate.inp --size 0.5 --elements quads
        quadrilaterals alone
  forefront mesh wing.json -o wing.su2 --layers "wing:first=1e-4,growth=1.2,count=20"
        20 thin layers along the boundary part wing
  forefront mesh cell.json -o cell.msh --periodic left:right --periodic bottom:top
        nodes on the right side that are images of those on the left, and pairs of them in the file
  forefront mesh dam.json -o dam.inp --crack joint
        double nodes along the inner line joint, whose faces become the boundary parts joint and joint_right
  forefront mesh dam.json -o dam.inp --strip joint:width=0.2,rows=2
        two rows of quadrilaterals along the inner line joint, in a strip of width 0.2
  forefront mesh pipe.json -o pipe.msh --elements quads --mapped wall
        rows of quadrilaterals in the region wall
  forefront mesh dam.json -o dam.inp --elements mixed --elements triangles:soil
        triangles in the region soil, quadrilaterals where they are well shaped elsewhere
  forefront mesh plate.json -o plate.inp --order 2
        triangles of 6 nodes, whose edges follow the curves of the domain
  forefront mesh part.dxf -o part.inp --size 2 --elements quads --order 2
        layers of a drawing as boundary parts: LOAD becomes the node set LOAD and the surface S_LOAD in the Abaqus input.
        The command "ccx job" solves a file job.inp such as this, in N and mm:
          *INCLUDE, INPUT=part.inp
          *MATERIAL, NAME=STEEL
          *ELASTIC
          210000, 0.3
          *SOLID SECTION, ELSET=EALL, MATERIAL=STEEL
          8
          ** 8 is the thickness; the nodes of the layer FIXED do not move; a pressure of 10 acts on the layer LOAD
          *BOUNDARY
          FIXED, 1, 2
          *STEP
          *STATIC
          *DSLOAD
          S_LOAD, P, 10
          *NODE FILE, OUTPUT=2D
          U
          *EL FILE
          S
          *END STEP
        "cgx -b show.fbd" shows the von Mises stress, with the lines read job.frd, ds 2 e 7, plot fv all and rot -z in show.fbd
  forefront mesh plate.json -o plate.foam
        a case of OpenFOAM, one cell thick
  forefront mesh lake.geojson -o lake.14 --elevation depth.asc
        a grid of ADCIRC with the depths of a raster
  forefront mesh coast.geojson -o fort.14 --projection local --name "sea:24.9,60.1;25.3,60.1" --open sea
        opens the part of the ring of a map between two places, given as longitude and latitude
  forefront mesh bay.geojson -o bay.14 --limit max-growth=2 --limit max-valence=8 --fix
        changes sizes until neighbours have similar areas and no node has more than 8 elements
  forefront mesh lake.geojson plate.poly -o "{}.vtu" --stats "{}.json"
        each file with its own outputs: lake.vtu, lake.json, plate.vtu, plate.json
  forefront mesh lake.geojson --size 0.1 --dry-run
        how many elements that would be, and about how much memory and time they would take
  forefront mesh lake.geojson --config fine.toml -o lake.vtu
        options of a file with lines such as size = 0.5, verify = true and set = {r = "2*d"}
  forefront mesh bay.geojson -o bay.14 --raster depth=sea.asc --spacing "max(50, 0.05*depth(x,y))"
        edges by the depth of the sea
  cat lake.geojson | forefront mesh - -o - --format vtu > lake.vtu
        from standard input to standard output

Exit codes: 0 done, 1 input refused (faults on stderr, one per line), 2 usage error, 3 cancelled.)help";

/// Parses the word of a grid or "uniform:COLSxROWS"; returns an error message for anything else.
std::string parseGrid(const std::string &text, MeshArguments &arguments) {
    arguments.grid = fromWord<GridKind>(text);
    if (arguments.grid) {
        return {};
    }
    constexpr std::string_view kUniform = "uniform:";
    if (text.starts_with(kUniform)) {
        const char *const end = text.data() + text.size();
        const auto columns = std::from_chars(text.data() + kUniform.size(), end, arguments.gridColumns);
        if (columns.ec == std::errc() && columns.ptr != end && *columns.ptr == 'x') {
            const auto rows = std::from_chars(columns.ptr + 1, end, arguments.gridRows);
            constexpr int kMaxCells = 100'000;
            const bool tooLarge = rows.ec == std::errc::result_out_of_range || arguments.gridRows > kMaxCells ||
                                  arguments.gridColumns > kMaxCells;
            if (rows.ptr == end && tooLarge) {
                return "--grid: the grid of '" + text + "' is too large; expected at most " +
                       std::to_string(kMaxCells) + " columns and rows";
            }
            if (rows.ec == std::errc() && rows.ptr == end && std::min(arguments.gridColumns, arguments.gridRows) >= 1 &&
                std::max(arguments.gridColumns, arguments.gridRows) <= kMaxCells) {
                arguments.grid = GridKind::Uniform;
                return {};
            }
        }
    }
    return "--grid: unknown grid '" + text + "'; expected " + wordList<GridKind>() + ", or uniform:COLSxROWS" +
           suggestion(text, wordsOf<GridKind>());
}

/// Returns the extensions of files of a kind that hold a spacing.
template <FileKind Kind>
std::string spacingFiles() {
    return extensionList([](const FileFormat &format) { return format.readsSpacing && format.kind == Kind; });
}

void addFrontOptions(CLI::App &app, MeshArguments &arguments, std::string &grid) {
    addElementsOption(app, arguments.elements);
    addWordOption<ElementOrder>(
        app, "--order", arguments.order,
        "1 (default), or 2: elements with nodes in the middles of their edges, on the curves of "
        "the domain; files have them after the corners, in the order of their format")
        ->type_name("ORDER");
    addWordOption<QuadNodes>(app, "--quad-nodes", arguments.quadNodes,
                             "nodes of a quadrilateral of order 2: 8 (default), or 9 with one in its centre")
        ->type_name("N");
    app.add_option(
           "--min-angle", arguments.leastAngle,
           "refine the triangles until none has a smaller angle, in degrees up to 33, except where corners of the "
           "domain or kept segments force it, which are named")
        ->type_name("DEGREES");
    addWordOption<Method>(app, "--method", arguments.method,
                          "fast (default), or classic: S. H. Lo's ten steps, shortest segment first")
        ->type_name("METHOD");
    addRulesOption(app, arguments.rules);
    app.add_option("--grid", grid,
                   "background grid: " + wordList<GridKind>() + ", or uniform:COLSxROWS; default " +
                       std::string(wordOf(MeshingOptions().grid)))
        ->check(offering(wordsOf<GridKind>()))
        ->type_name("KIND");
    app.add_flag("--keep-boundary", arguments.keepBoundary,
                 "keep the given segments as mesh edges; do not subdivide them");
    app.add_flag("--repair", arguments.repair,
                 "first split segments where they cross, merge duplicates and drop parts outside the domain, and "
                 "report every change; always done for drawings and maps");
    auto *improve =
        addWordOption<ImproveLevel>(app, "--improve", arguments.improve,
                                    "improve the element shapes: none (fastest; leave the mesh as the front made it), "
                                    "default, or best (slower; also adds and removes interior nodes)")
            ->type_name("LEVEL");
    app.add_flag("--verify", arguments.verify,
                 "check the finished mesh against its domain, as check --domain does, before it is written");
    app.add_flag_callback(
           "--no-improve", [&arguments] { arguments.improve = ImproveLevel::None; }, "the same as --improve none")
        ->excludes(improve);
}

void addImportOptions(CLI::App &app, MeshArguments &arguments) {
    addParameterOption(app, arguments.parameters);
    addDrawingOptions(app, arguments.drawing);
    app.add_flag("--strict", arguments.strict, "refuse input that would need changes")
        ->excludes(app.get_option("--repair"));
}

/// Returns the files that are written for each input, without standard output.
std::vector<std::filesystem::path> namedOutputs(const MeshArguments &arguments) {
    std::vector<std::filesystem::path> files = arguments.outputs;
    if (arguments.statistics && !arguments.printsStatistics()) {
        files.push_back(*arguments.statistics);
    }
    return files;
}

} // namespace

MeshArguments MeshArguments::of(const std::filesystem::path &file) const {
    MeshArguments one = *this;
    one.input = file;
    for (std::filesystem::path &output : one.outputs) {
        output = withStem(output, file);
    }
    if (one.statistics) {
        one.statistics = withStem(*one.statistics, file);
    }
    return one;
}

std::variant<MeshArguments, int> parseMeshArguments(const CommandLine &line) {
    MeshArguments arguments;
    std::string grid;
    std::vector<std::string> layers;
    CLI::App app("Meshes a planar domain with triangles or quadrilaterals by the advancing front technique.",
                 "forefront mesh");
    app.footer(kMeshExamples);
    app.add_option("IN", arguments.inputs,
                   "project (" + extensionList([](const FileFormat &each) { return each.kind == FileKind::Project; }) +
                       ") or domain (" + extensionList([](const FileFormat &each) {
                           return each.readsDomain && each.kind != FileKind::Project;
                       }) +
                       "); -: standard input; several: each is meshed, and {} in the names of outputs is replaced by "
                       "the name of the input without its extension")
        ->required();
    addInputFormatOption(app, "IN", arguments.inputFormat);
    addOutputOptions(app, arguments.outputs, arguments.formats, arguments.form);
    addFormOptions(app, arguments.form, "the unit of the input, if it has one");
    auto *spacing = app.add_option_group("Spacing", "at most one; default: from the project, or automatic");
    addSpacingOptions(*spacing, arguments.size, arguments.expression);
    addRasterOptions(app, *spacing, arguments.rasters, arguments.presets);
    spacing
        ->add_option("--spacing-file", arguments.spacingFile,
                     "use the spacing of a project, a background mesh (" + spacingFiles<FileKind::Mesh>() +
                         "), a grid of sizes (" + spacingFiles<FileKind::Grid>() + ") or a picture (" +
                         spacingFiles<FileKind::Picture>() +
                         "); of any mesh without nodal values, the sizes of its elements")
        ->type_name("FILE");
    spacing->add_flag("--size-from-boundary", arguments.sizeFromBoundary,
                      "the lengths of the given segments alone; with --gradation 0.7 and --min-angle, few elements");
    spacing->require_option(0, 1);
    addPictureOptions(app, arguments.pictureSizes, arguments.pictureBox);
    app.add_option_function<double>(
           "--target-elements",
           [&arguments](double count) { arguments.targetElements = static_cast<std::uint64_t>(count); },
           "scale all element sizes until the mesh has about this number of elements, within 5 %; a minimum size, "
           "kept segments and curves may hold them, which is reported")
        ->check(numberWithin(1.0, static_cast<double>(kMaxElements)))
        ->type_name("N");
    app.add_option(
           "--gradation", arguments.gradation,
           "maximum change of edge length per unit of distance; default: 0.25 where sizes spread from the boundary, "
           "regions and paint, 0.5 for expressions and background meshes")
        ->check(positiveNumber())
        ->type_name("G");
    app.add_option("--segments-per-turn", arguments.segmentsPerTurn,
                   "elements per full turn of a curve, within 2 %; 0: only the chord tolerance counts; default: 40 "
                   "with automatic spacing, else 0")
        ->check(nonNegativeNumber())
        ->type_name("N");
    app.add_option("--elements-across", arguments.elementsAcross,
                   "elements across narrow places; 0: ignore narrow places; default: 2 with automatic spacing, "
                   "else 0")
        ->check(nonNegativeNumber())
        ->type_name("N");
    addCurveToleranceOption(app, arguments.curveTolerance);
    addLayersOption(app, layers);
    addPeriodicOption(app, arguments.periodic);
    addCrackOptions(app, arguments.cracks,
                    "make a crack of the inner line NAME: the elements on its two sides get nodes of their own; the "
                    "face on the right of the line is named NAME_right; can be repeated");
    addMappedOption(app, arguments.mapped);
    addStripOption(app, arguments.strips,
                   "give the inner line NAME a width, and fill the strip along it by rows of elements, such as "
                   "wall:width=0.2,rows=2; type=triangles divides the quadrilaterals; region=TAG: of the strip, which "
                   "otherwise is a region of its own, with the name of the line; can be repeated");
    addFrontOptions(app, arguments, grid);
    addFixOptions(app, arguments.limits, arguments.fix);
    addImportOptions(app, arguments);
    app.add_option("--threads", arguments.threads, "number of threads, 1 to 256; the mesh does not depend on it")
        ->check(wholeNumberWithin(1, 256))
        ->type_name("N");
    addMaxElementsOption(app, arguments.maxElements);
    app.add_option("--stats", arguments.statistics, "write statistics as JSON; -: print them instead of the summary")
        ->type_name("FILE.json");
    auto *const dry =
        app.add_flag("--dry-run", arguments.dryRun, "estimate elements, memory and time; nothing is written");
    app.add_flag("--json", arguments.json, "print the estimate of --dry-run as JSON")->needs(dry);
    app.add_flag("-q,--quiet", arguments.quiet, "print only warnings and errors");
    addConfigOption(app);
    if (const auto code = parseOptions(app, line)) {
        return *code;
    }
    std::string wrong = grid.empty() ? std::string() : parseGrid(grid, arguments);
    if (wrong.empty()) {
        wrong = parseLayers(layers, arguments.layers);
    }
    if (wrong.empty()) {
        wrong = parseStrips(arguments.strips);
    }
    if (wrong.empty()) {
        wrong = parseElements(arguments.elements);
    }
    if (wrong.empty()) {
        wrong = checkRasters(arguments.rasters, arguments.presets, arguments.expression);
    }
    if (wrong.empty()) {
        wrong = checkFormats(arguments.outputs, arguments.formats);
    }
    if (wrong.empty()) {
        wrong = checkInputs({arguments.inputs.front(), arguments.spacingFile}, arguments.inputFormat);
    }
    if (wrong.empty()) {
        wrong = checkStems(arguments.inputs, namedOutputs(arguments));
    }
    if (wrong.empty() && (arguments.pictureSizes || arguments.pictureBox) && !arguments.spacingFile) {
        wrong = "--picture-sizes and --picture-box belong to a picture; add --spacing-file FILE.png";
    }
    if (wrong.empty() && arguments.printsStatistics() && usesStandardOutput(arguments.outputs)) {
        wrong = "-o - and --stats - both write to standard output; give one of them a file";
    }
    if (wrong.empty() && arguments.outputs.empty() && (arguments.form.innerEdges || arguments.form.numbering)) {
        wrong = std::string(arguments.form.innerEdges ? "--inner-edges" : "--numbering") +
                ": no mesh is written; add -o OUT";
    }
    if (wrong.empty()) {
        wrong = checkForm(arguments.form, pairFormats(arguments.outputs, arguments.formats), arguments.order);
    }
    if (wrong.empty() && arguments.outputs.empty() && !arguments.statistics && !arguments.dryRun) {
        wrong = "no output; add -o OUT or --stats FILE.json";
    }
    if (!wrong.empty()) {
        return wrongUsage(app.get_name(), wrong);
    }
    return arguments;
}

} // namespace forefront
