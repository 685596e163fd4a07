/// Renders the cell during a push without a display, and writes the picture as PPM.

#include <EGL/egl.h>
#include <mujoco/mujoco.h>

#include <fstream>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "simulated_cell.h"

namespace contact_shapelets::simulation {
namespace {

/// An OpenGL context without a window.
class OffscreenContext {
 public:
  OffscreenContext() {
    const EGLint attributes[] = {EGL_RED_SIZE,
                                 8,
                                 EGL_GREEN_SIZE,
                                 8,
                                 EGL_BLUE_SIZE,
                                 8,
                                 EGL_DEPTH_SIZE,
                                 24,
                                 EGL_RENDERABLE_TYPE,
                                 EGL_OPENGL_BIT,
                                 EGL_SURFACE_TYPE,
                                 EGL_PBUFFER_BIT,
                                 EGL_NONE};
    display_ = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglInitialize(display_, nullptr, nullptr) != EGL_TRUE ||
        eglChooseConfig(display_, attributes, &config, 1, &count) != EGL_TRUE || count < 1 ||
        eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) {
      throw std::runtime_error("EGL has no OpenGL here; EGL_PLATFORM=surfaceless may help");
    }
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, nullptr);
    if (context_ == EGL_NO_CONTEXT || eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE) {
      throw std::runtime_error("EGL cannot make a context without a surface");
    }
  }
  ~OffscreenContext() { eglTerminate(display_); }
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

 private:
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

void Render(CellModel* cell, const std::string& camera, int width, int height, const std::string& path) {
  mjvScene scene;
  mjv_defaultScene(&scene);
  mjv_makeScene(cell->model(), &scene, 500);
  mjrContext context;
  mjr_defaultContext(&context);
  mjr_makeContext(cell->model(), &context, mjFONTSCALE_100);
  mjr_setBuffer(mjFB_OFFSCREEN, &context);
  mjvOption options;
  mjv_defaultOption(&options);
  options.flags[mjVIS_TENDON] = 0;
  mjvCamera view;
  mjv_defaultCamera(&view);
  view.type = mjCAMERA_FIXED;
  view.fixedcamid = mj_name2id(cell->model(), mjOBJ_CAMERA, camera.c_str());
  mjv_updateScene(cell->model(), cell->data(), &options, nullptr, &view, mjCAT_ALL, &scene);
  const mjrRect viewport{0, 0, width, height};
  mjr_render(viewport, &scene, &context);
  std::vector<unsigned char> pixels(static_cast<std::size_t>(3 * width * height));
  mjr_readPixels(pixels.data(), nullptr, viewport, &context);
  mjr_freeContext(&context);
  mjv_freeScene(&scene);

  std::ofstream file(path, std::ios::binary);
  file << "P6\n" << width << ' ' << height << "\n255\n";
  // OpenGL's first row is the lowest.
  for (int row = height - 1; row >= 0; --row) {
    file.write(reinterpret_cast<const char*>(pixels.data()) + 3L * width * row, 3L * width);
  }
  if (!file) throw std::runtime_error("cannot write " + path);
}

void RenderPush(const std::string& camera, const std::string& path) {
  const OffscreenContext context;
  SimulatedCell cell{PushCondition{}};
  cell.BeginPush();
  // The lever is then on its way up to dead centre.
  while (cell.state().lever_angle < -0.6 * CellModel::kStop && cell.state().time < 10.0) cell.Step();
  Render(&cell.model(), camera, 1000, 750, path);
}

}  // namespace
}  // namespace contact_shapelets::simulation

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: render_cell {cell|switch} OUT.ppm\n";
    return 2;
  }
  try {
    contact_shapelets::simulation::RenderPush(argv[1], argv[2]);
  } catch (const std::exception& error) {
    std::cerr << "render_cell: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
