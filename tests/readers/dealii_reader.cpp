// Reads a mesh with deal.II and prints what it holds as JSON: cells and area by material, faces and length by boundary.
//   dealii_reader FORMAT FILE      FORMAT: msh, vtk
#include <cstdint>
#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/tria.h>
#include <exception>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <string>

namespace {

struct Part {
    unsigned count = 0;
    double measure = 0.0;
};

void print(const char *name, const std::map<std::int64_t, Part> &parts) {
    std::cout << '"' << name << "\": {";
    const char *separator = "";
    for (const auto &[number, part] : parts) {
        std::cout << separator << '"' << number << "\": [" << part.count << ", " << part.measure << ']';
        separator = ", ";
    }
    std::cout << '}';
}

void read(const std::string &format, const std::string &path) {
    dealii::Triangulation<2> mesh;
    dealii::GridIn<2> reader(mesh);
    std::ifstream file(path);
    if (format == "vtk") {
        reader.read_vtk(file);
    } else {
        reader.read_msh(file);
    }
    std::map<std::int64_t, Part> regions, boundaries;
    for (const auto &cell : mesh.active_cell_iterators()) {
        Part &region = regions[cell->material_id()];
        ++region.count;
        region.measure += cell->measure();
        for (const unsigned face : cell->face_indices()) {
            if (cell->face(face)->at_boundary()) {
                Part &boundary = boundaries[cell->face(face)->boundary_id()];
                ++boundary.count;
                boundary.measure += cell->face(face)->measure();
            }
        }
    }
    std::cout << std::setprecision(17) << "{\"nodes\": " << mesh.n_used_vertices() << ", ";
    print("regions", regions);
    std::cout << ", ";
    print("edges", boundaries);
    std::cout << "}\n";
}

} // namespace

int main(int argc, char **argv) {
    if (argc != 3) {
        std::cerr << "usage: dealii_reader FORMAT FILE\n";
        return 2;
    }
    try {
        read(argv[1], argv[2]);
    } catch (const std::exception &problem) {
        std::cerr << problem.what() << '\n';
        return 1;
    }
    return 0;
}
