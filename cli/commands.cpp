// The rows.
#include <algorithm>
#include <array>

#include "cli/command.hpp"

namespace mansard {
namespace {

constexpr Flag style_flag{"--style", "NAME",
                          "the style to derive (default: the last one of the file)"};
constexpr Flag seed_flag{"--seed", "N",
                         "another number, another variation (default: the style's @seed, else 0)"};
constexpr Flag set_flag{"--set", "NAME=VALUE",
                        "gives a variable another value: --set Tile.WindowWidth=1.2", true};
constexpr Flag attr_flag{"--attr", "NAME=VALUE", "a property for every footprint", true};
constexpr Flag path_flag{"--style-path", "DIR", "where imports and meshes are looked for too",
                         true};
constexpr Flag id_flag{"--id", "NAME", "the property that identifies a footprint"};
constexpr Flag layer_flag{"--layer", "NAME", "the layer of the file to read"};
constexpr Flag where_flag{"--where", "CONDITION",
                          "only footprints for which this SQL condition holds"};
constexpr Flag select_flag{"--select", "id=ID", "only this footprint", true};
constexpr Flag limit_flag{"--limit", "N", "only the first N footprints"};
constexpr Flag small_flag{"--drop-small", "",
                          "leaves out footprints under a tenth of the mean area: sheds, splinters"};
constexpr Flag streets_flag{"--streets", "FILE",
                            "lines of streets, of a GIS file or WKT:LINESTRING(...): the walls "
                            "that look at one are street walls"};
constexpr Flag streets_layer_flag{"--streets-layer", "NAME", "the layer of that file to read"};
constexpr Flag streets_where_flag{"--streets-where", "CONDITION",
                                  "only streets for which this SQL condition holds"};
constexpr Flag lod_flag{"--lod", "N",
                        "level of detail: 1 masses, 2 without relief, 3 everything (default)"};
constexpr Flag depth_flag{"--max-depth", "N", "how deep a shape tree may grow (default 1000)"};
constexpr Flag shapes_flag{"--max-shapes", "N",
                           "how many shapes a building may have (default 5000000)"};
constexpr Flag strict_flag{"--strict", "", "a shape that no production fits is an error"};
constexpr Flag keep_flag{"--keep-going", "", "leave out what fails, write the rest, exit with 1"};
constexpr Flag json_flag{"--json", "", "for machines: JSON"};
constexpr Flag quiet_flag{"--quiet", "", "no progress and no summary"};
constexpr Flag color_flag{"--no-color", "", "no colours on a terminal"};
constexpr Flag threads_flag{"--threads", "N",
                            "how many threads, at most one a core (default: all)"};

constexpr std::array variation_flags{style_flag, seed_flag, set_flag, attr_flag, lod_flag};
constexpr std::array one_plot_flags{select_flag, id_flag, layer_flag, where_flag};
constexpr std::array street_flags{streets_flag, streets_layer_flag, streets_where_flag};
constexpr std::array plots_flags{select_flag, limit_flag, small_flag,
                                 id_flag,     layer_flag, where_flag};
constexpr std::array derivation_flags{path_flag, depth_flag, shapes_flag, strict_flag};
constexpr std::array printing_flags{json_flag, quiet_flag, color_flag};

constexpr std::span<const Flag> list_of(const Flag& flag) { return {&flag, 1}; }
constexpr std::span<const Flag> list_of(std::span<const Flag> flags) { return flags; }

template <class Part>
constexpr std::size_t count_of = std::tuple_size_v<Part>;
template <>
constexpr std::size_t count_of<Flag> = 1;

/// Flags and lists of flags, one after the other.
template <class... Parts>
constexpr auto joined(const Parts&... parts) {
  std::array<Flag, (count_of<Parts> + ...)> all;
  auto end = all.begin();
  ((end = std::ranges::copy(list_of(parts), end).out), ...);
  return all;
}

constexpr auto derive_flags =
    joined(Flag{"-o,--output", "OUT",
                "the model to write; its ending says the format: .obj, .glb, .gltf, .ply or .stl"},
           style_flag, seed_flag, set_flag, attr_flag,
           Flag{"--lod", "N|all",
                "level of detail: 1 masses, 2 without relief, 3 everything (default); all writes "
                "the three: town_lod1.obj and so on"},
           threads_flag, plots_flags, street_flags,
           Flag{"--report", "FILE.json", "counts, areas and report() values"},
           Flag{"--up", "y|z", "which axis points up in an .obj, .ply or .stl (default y)"},
           Flag{"--instancing", "nodes|gpu|none",
                "how glTF repeats what is alike: nodes that share a mesh (default), instances of "
                "EXT_mesh_gpu_instancing, or every copy by itself"},
           Flag{"--compress", "draco",
                "glTF's triangles by KHR_draco_mesh_compression, a tenth of a millimetre exact"},
           derivation_flags, keep_flag, printing_flags);
constexpr auto check_flags = joined(path_flag, set_flag, printing_flags);
constexpr auto format_flags =
    joined(Flag{"--write", "", "change the files in place, those that need it"},
           Flag{"--diff", "", "print what would change, as a unified diff"},
           Flag{"--check", "", "name the files that would change and exit with 1; for tests"},
           printing_flags);
constexpr auto explain_flags = joined(
    set_flag, attr_flag,
    Flag{"--footprint", "FOOTPRINTS", "whose properties and draws decide: a file, or rect:10x8"},
    seed_flag, one_plot_flags, path_flag, printing_flags);
constexpr auto tree_flags =
    joined(variation_flags, one_plot_flags, street_flags,
           Flag{"--symbol", "NAME", "only what hangs below shapes of this symbol"},
           Flag{"--depth", "N", "only this many levels"}, Flag{"--dot", "", "a graph for Graphviz"},
           Flag{"--rounds", "", "what shapes asked about others, what came of it and why"},
           Flag{"--sizes", "", "what the sizes ':' of splits measured and got"}, derivation_flags,
           printing_flags);
constexpr auto render_flags = joined(
    Flag{"-o,--output", "PICTURE.png", "the picture to write"},
    Flag{"--camera", "VIEW", "iso (default), street, or x,y,z,tx,ty,tz: eye and target in metres"},
    Flag{"--size", "WxH", "pixels (default 1200x800)"}, variation_flags, threads_flag, plots_flags,
    street_flags, derivation_flags, keep_flag, printing_flags);
constexpr auto vary_flags = joined(
    Flag{"-o,--output", "SHEET.png", "the contact sheet to write"},
    Flag{"--count", "N", "this many seeds, from --seed on (default 12 when nothing else varies)"},
    Flag{"--styles", "A,B,C", "a picture of each of these styles"},
    Flag{"--sweep", "NAME[=VALUES]",
         "a picture of each value of a variable: from:to:step, or values separated by commas; "
         "without any, what its @range or @choice says; two make rows and columns",
         true},
    Flag{"--export", "DIR",
         "writes each variation there too, as a model and as a style of three lines"},
    Flag{"--camera", "VIEW", "iso (default), street, or x,y,z,tx,ty,tz: the same for all pictures"},
    Flag{"--size", "WxH", "pixels of each picture (default 400x300)"}, variation_flags,
    threads_flag, plots_flags, street_flags, derivation_flags,
    Flag{"--keep-going", "", "a picture that fails says why, the others are drawn; exit with 1"},
    printing_flags);
constexpr std::array stains_flags{
    Flag{"-o,--output", "STAINS.png", "the picture to write; derive takes stains.png"},
    Flag{"--seed", "N", "another number, other stains (default 0)"}, threads_flag, quiet_flag};
constexpr std::array help_flags{json_flag};
constexpr std::array lsp_flags{path_flag};

constexpr std::array rows{
    Command{"derive", "FILE.style FOOTPRINTS -o OUT", "derives a building for every footprint", 2,
            2, derive_flags,
            "mansard derive terrace.style rect:6x10 -o terrace.obj\n"
            "mansard derive quarter.style footprints.geojson --seed 7 -o quarter.glb",
            run_derive},
    Command{"check", "FILE.style...",
            "reads, links and checks scripts without deriving: every error and warning at once", 1,
            10000, check_flags, "mansard check terrace.style", run_check},
    Command{"format", "[FILE.style...]",
            "lays scripts out anew; from standard input without a file or for -", 0, 10000,
            format_flags,
            "mansard format terrace.style\nmansard format --write styles/*.style\nmansard format "
            "--check --diff styles/*.style",
            run_format},
    Command{
        "explain", "FILE.style [STYLE] [NAME]",
        "shows where everything in a style comes from: its order, who gives what, what it hides", 1,
        3, explain_flags,
        "mansard explain sills.style\nmansard explain sills.style Sills Tile.Width\n"
        "mansard explain quarter.style Villa TILE\n"
        "mansard explain sills.style Tile --set Tile.Width=1.2",
        run_explain},
    Command{"tree", "FILE.style FOOTPRINT", "prints the shape tree of a footprint", 2, 2,
            tree_flags,
            "mansard tree terrace.style rect:6x10 --depth 3\nmansard tree terrace.style rect:6x10 "
            "--symbol TILE",
            run_tree},
    Command{"render", "MODEL | FILE.style FOOTPRINTS -o PICTURE.png",
            "draws a model, or what a style makes of footprints", 1, 2, render_flags,
            "mansard render terrace.style rect:6x10 -o terrace.png\nmansard render quarter.obj "
            "--camera street -o street.png",
            run_render},
    Command{
        "vary", "FILE.style FOOTPRINTS -o SHEET.png",
        "draws variations side by side: seeds, styles, or the values of a variable", 2, 2,
        vary_flags,
        "mansard vary terrace.style rect:6x10 -o sheet.png\nmansard vary terrace.style rect:6x10 "
        "--sweep Tile.WindowWidth=0.6:1.4:0.2 --export variations -o sheet.png\nmansard vary "
        "terrace.style rect:6x10 --styles Terrace,TerraceWithSills --count 4 -o sheet.png",
        run_vary},
    Command{"stains", "-o stains.png",
            "makes the picture of rain streaks that stain() lays below sills and ledges", 0, 0,
            stains_flags, "mansard stains --seed 7 -o stains.png", run_stains},
    Command{"lsp", "", "the language server for editors, on standard input and output", 0, 0,
            lsp_flags, "mansard lsp --style-path ../styles", run_lsp},
    Command{"help", "[TOPIC]",
            "explains a command, an operation, a function, a warning or a topic of the language", 0,
            1, help_flags,
            "mansard help derive\nmansard help roof\nmansard help sizes\nmansard help W010",
            run_help},
};

}  // namespace

std::span<const Command> commands() { return rows; }

const Command* find_command(std::string_view name) {
  const auto it = std::ranges::find(rows, name, &Command::name);
  return it == rows.end() ? nullptr : &*it;
}

}  // namespace mansard
