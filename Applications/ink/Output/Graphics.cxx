// SPDX-License-Identifier: BSD-3-Clause
#include "Graphics.h"

#include "Pattern.h"
#include "VtkMessages.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkSmartPointer.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ink::cli
{
namespace
{

std::string capability(const std::string& report, const std::string& name)
{
  const std::vector<std::string> match =
    io::Pattern("OpenGL " + name + " string:\\s*([^\\n]*)").search(report);
  return match.empty() ? "" : match[1];
}

/// Runs in the child: writes the class of the window, then the description of its context, a line each.
[[noreturn]] void describeContext(int descriptor)
{
  // No core file if VTK aborts.
  const rlimit none{ 0, 0 };
  setrlimit(RLIMIT_CORE, &none);
  const auto send = [descriptor](const std::string& line)
  {
    return write(descriptor, (line + "\n").c_str(), line.size() + 1) == static_cast<ssize_t>(line.size() + 1);
  };

  const VtkMessages messages;
  const auto window = vtk::TakeSmartPointer(vtkOpenGLRenderWindow::SafeDownCast(vtkRenderWindow::New()));
  bool sent = send(window->GetClassName());
  window->OffScreenRenderingOn();
  window->SetSize(16, 16);
  // Not drawn in, which takes ten times as long.
  window->Initialize();
  const std::string report = window->ReportCapabilities();
  const std::string version = capability(report, "version");
  sent = sent &&
    send(capability(report, "vendor") + ", " + capability(report, "renderer") + ", OpenGL " + version);
  _exit(sent && !version.empty() ? EXIT_SUCCESS : EXIT_FAILURE);
}

std::string readAll(int descriptor)
{
  std::string text;
  char buffer[4096];
  for (;;)
  {
    const ssize_t count = read(descriptor, buffer, sizeof(buffer));
    if (count > 0)
    {
      text.append(buffer, static_cast<std::size_t>(count));
    }
    else if (count == 0 || errno != EINTR)
    {
      return text;
    }
  }
}

} // namespace

Graphics probeGraphics()
{
  Graphics graphics;
  int ends[2];
  if (pipe(ends) != 0)
  {
    graphics.description = std::strerror(errno);
    return graphics;
  }
  const pid_t child = fork();
  if (child == 0)
  {
    close(ends[0]);
    describeContext(ends[1]);
  }
  close(ends[1]);
  const std::string answer = readAll(ends[0]);
  close(ends[0]);
  int status = -1;
  while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR)
  {
  }

  const auto lineEnd = answer.find('\n');
  graphics.windowClass = answer.substr(0, lineEnd);
  graphics.works = child > 0 && WIFEXITED(status) && WEXITSTATUS(status) == EXIT_SUCCESS;
  if (graphics.works)
  {
    graphics.description = answer.substr(lineEnd + 1, answer.size() - lineEnd - 2);
  }
  else if (graphics.windowClass == "vtkXOpenGLRenderWindow")
  {
    const char* display = std::getenv("DISPLAY");
    graphics.description = (display && *display ? "no display: '" + std::string(display) + "' cannot be used"
                                                : std::string("no display: DISPLAY is not set")) +
      "; run under: xvfb-run -a ink ...";
  }
  else
  {
    graphics.description = "no OpenGL context could be made";
  }
  return graphics;
}

} // namespace ink::cli
