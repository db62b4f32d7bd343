// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Writes a script, runs the program, reads what it wrote.
#include "gmsh_remesh.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>

#include "mortise/mortise.h"

namespace mortise::peers {
namespace {

constexpr rlim_t most_seconds = 300;

void write_script(const std::string& path, double size) {
  std::ofstream script(path + ".geo");
  script.precision(17);
  script << "Merge \"" << std::filesystem::path(path).filename().string() << ".stl\";\n"
         << "ClassifySurfaces{40*Pi/180, 1, 1, 45*Pi/180};\nCreateGeometry;\nMesh.Algorithm = 6;\nMesh.MshFileVersion = 2.2;\n"
         << "Mesh.MeshSizeMin = " << size << ";\nMesh.MeshSizeMax = " << size << ";\n";
}

/// What becomes of the process that is to be Gmsh.
[[noreturn]] void become_gmsh(const std::string& path) {
  const rlimit limit{most_seconds, most_seconds};
  setrlimit(RLIMIT_CPU, &limit);
  const int log = open((path + ".log").c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0644);
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  const std::string script = path + ".geo", mesh = path + ".msh";
  execlp("gmsh", "gmsh", script.c_str(), "-2", "-nt", "1", "-o", mesh.c_str(), static_cast<char*>(nullptr));
  _exit(127);
}

double seconds_of(const timeval& time) { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); }

std::string refusal_of(int status) {
  if (WIFSIGNALED(status)) return WTERMSIG(status) == SIGKILL || WTERMSIG(status) == SIGXCPU ? "takes more than 300 s" : "crashes";
  return WEXITSTATUS(status) == 127 ? "is not installed" : "fails";
}

}  // namespace

RemesherAnswer gmsh_remesh(const SurfaceMesh& mesh, double size, const std::string& path) {
  std::filesystem::remove(path + ".msh");
  write_mesh_file(path + ".stl", mesh);
  write_script(path, size);
  RemesherAnswer answer;
  const pid_t child = fork();
  if (child == 0) become_gmsh(path);
  int status = 0;
  rusage usage{};
  if (child < 0 || wait4(child, &status, 0, &usage) < 0) return {"cannot be started", {}, {}, 0, 0};
  answer.seconds = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
  answer.megabytes = static_cast<double>(usage.ru_maxrss) / 1024;
  if (!std::filesystem::exists(path + ".msh")) {
    answer.refusal = refusal_of(status);
    return answer;
  }
  try {
    answer.mesh = weld(read_mesh_file(path + ".msh")).mesh;
    answer.mesh.face_labels.clear();
    answer.mesh.label_names.clear();
    BrepRules rules;
    rules.seams = Seams::None;
    answer.model = build_brep(answer.mesh, rules);
  } catch (const Error& error) {
    answer.refusal = std::string("writes what is no mesh: ") + error.what();
  }
  if (answer.refusal.empty() && answer.mesh.triangles.empty()) answer.refusal = "makes no triangles";
  return answer;
}

}  // namespace mortise::peers
