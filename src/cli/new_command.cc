#include <filesystem>
#include <iostream>

#include "base/files.h"
#include "case/new_case.h"
#include "cli/command.h"
#include "upbead/base/error.h"
#include "upbead/case/case.h"
#include "upbead/input/node.h"

namespace upbead {

namespace {

namespace fs = std::filesystem;

struct NewOptions : NewCase {
  std::string file;
};

const char* const schema_name = "upbead-case.schema.json";

int write(const NewOptions& options) {
  const fs::path path(options.file), schema = path.parent_path() / schema_name;
  if (fs::exists(path)) throw InputError({}, "'" + options.file + "' is there already", "give another name");
  const std::string text = new_case(options, path.stem().string());
  write_whole(path.string(), "#:schema " + std::string(schema_name) + "\n" + text);
  std::cout << "written     " << options.file << "\n";
  if (!fs::exists(schema)) {
    write_whole(schema.string(), case_json_schema());
    std::cout << "written     " << schema.string() << ", by which an editor completes and checks the case\n";
  }
  std::cout << "next        upbead explain " << options.file << "\n            upbead run " << options.file << "\n";
  return 0;
}

const char* const new_footer =
    R"(Writes FILE, a commented case: a caisson on a rubble mound in the sea under one design wave. Soils, slopes and limits
are assumed, as their comments say. Beside it lies the JSON Schema of cases, by which an editor with a TOML language
server (taplo, in VS Code "Even Better TOML") completes keys and underlines mistakes. Nothing that exists is replaced.

Examples:
  upbead new breakwater.toml
  upbead new breakwater.toml --width 20 --height 17 --depth 12 --mound 5 --wave-height 8 --period 12)";

}  // namespace

Command new_command() {
  const auto options = std::make_shared<NewOptions>();
  Command command{"new", "write a commented case to begin with, from a few numbers"};
  const auto length = [](const std::string& name, double& value, const std::string& what) {
    return Option{name, &value, what + " (m; default: " + number_text(value) + ")", "", false, true};
  };
  NewOptions& o = *options;
  command.options = {
      {"FILE", &o.file, "case to write, such as breakwater.toml", "", true},
      length("--width", o.width, "width of the caisson"),
      length("--height", o.height, "height of the caisson"),
      length("--depth", o.depth, "depth of still water over the seabed"),
      length("--mound", o.mound, "height of the mound"),
      length("--armour", o.armour, "thickness of the armour on the mound"),
      length("--shoulder", o.shoulder, "width of the mound's crest beside the caisson, on either side"),
      length("--seabed", o.seabed, "thickness of the seabed above a rigid base"),
      length("--wave-height", o.wave_height, "highest wave"),
      {"--period", &o.period, "its period (s; default: " + number_text(o.period) + ")", "", false, true},
  };
  command.footer = new_footer;
  command.work = [options] { return write(*options); };
  return command;
}

}  // namespace upbead
