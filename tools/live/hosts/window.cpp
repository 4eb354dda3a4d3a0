#define SDL_MAIN_HANDLED
#include "tools/live/hosts/panel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace cookbook::live
{

namespace
{

/// SDL while it is needed.
struct Sdl
{
  Sdl()
  {
    SDL_SetHint(SDL_HINT_RENDER_SCALE_QUALITY, "linear");
    SDL_SetHint(SDL_HINT_VIDEO_X11_NET_WM_BYPASS_COMPOSITOR, "0");
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    SDL_SetMainReady();
    if (SDL_Init(SDL_INIT_VIDEO) != 0)
    {
      failed(SDL_GetError());
    }
    // Without a screen SDL draws into memory, and nothing could ever close the window.
    const std::string driver = SDL_GetCurrentVideoDriver();
    if (SDL_getenv("SDL_VIDEODRIVER") == nullptr && (driver == "offscreen" || driver == "dummy"))
    {
      SDL_Quit();
      failed("there is no screen");
    }
  }
  Sdl(const Sdl&) = delete;
  Sdl& operator=(const Sdl&) = delete;
  ~Sdl() { SDL_Quit(); }

  [[noreturn]] static void failed(const std::string& why)
  {
    throw std::runtime_error(
        "no window can be opened here: " + why +
        " (./cookbook play --terminal shows it in a terminal)");
  }
};

/// A window and what belongs to it.
struct Window
{
  SDL_Window* window;
  SDL_Renderer* renderer = nullptr;
  SDL_Texture* texture = nullptr;
  int texture_width = 0, texture_height = 0;

  explicit Window(const std::string& name)
      : window(SDL_CreateWindow(
            name.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, 640, 480,
            SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI | SDL_WINDOW_HIDDEN))
  {
    renderer = window == nullptr ? nullptr : SDL_CreateRenderer(window, -1, 0);
    if (renderer == nullptr)
    {
      Sdl::failed(SDL_GetError());
    }
  }
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;
  ~Window()
  {
    SDL_DestroyTexture(texture);
    SDL_DestroyRenderer(renderer);
    SDL_DestroyWindow(window);
  }
};

/// The window takes these parts, in the middle of the screen; where that is large, up to twice as
/// large, in quarters.
void fit(Window& window, const Parts& parts)
{
  SDL_Rect screen{};
  double scale = 1;
  if (SDL_GetDisplayUsableBounds(SDL_GetWindowDisplayIndex(window.window), &screen) == 0)
  {
    const double most = std::min(0.85 * screen.w / parts.width, 0.85 * screen.h / parts.height);
    scale = std::clamp(std::floor(4 * most) / 4, 1.0, 2.0);
  }
  SDL_SetWindowSize(window.window, int(parts.width * scale), int(parts.height * scale));
  SDL_SetWindowPosition(window.window, SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED);
  SDL_RenderSetLogicalSize(window.renderer, parts.width, parts.height);
}

/// Copies the pixels that the figure shows into the window's upper left corner.
void draw_picture(Window& window, const Session& session)
{
  const int width = session.picture_width(), height = session.picture_height();
  if (width != window.texture_width || height != window.texture_height)
  {
    SDL_DestroyTexture(window.texture);
    window.texture = SDL_CreateTexture(
        window.renderer, SDL_PIXELFORMAT_RGBA32, SDL_TEXTUREACCESS_STREAMING, width, height);
    window.texture_width = width;
    window.texture_height = height;
  }
  SDL_UpdateTexture(window.texture, nullptr, session.pixels().data(), 4 * width);
  const SDL_Rect place = {0, 0, width, height};
  SDL_RenderCopy(window.renderer, window.texture, nullptr, &place);
}

/// The name of a key as controls know it.
std::string key_name(SDL_Keycode key)
{
  static const std::array<std::pair<SDL_Keycode, const char*>, 12> names = {
      {{SDLK_SPACE, "space"},
       {SDLK_TAB, "tab"},
       {SDLK_UP, "up"},
       {SDLK_DOWN, "down"},
       {SDLK_LEFT, "left"},
       {SDLK_RIGHT, "right"},
       {SDLK_RETURN, "enter"},
       {SDLK_KP_ENTER, "enter"},
       {SDLK_ESCAPE, "escape"},
       {SDLK_KP_PLUS, "+"},
       {SDLK_KP_MINUS, "-"},
       {SDLK_KP_PERIOD, "."}}};
  for (const auto& [code, name] : names)
  {
    if (code == key)
    {
      return name;
    }
  }
  return key > ' ' && key < 127 ? std::string(1, char(key)) : std::string();
}

/// A figure in a window: what the mouse holds, what it has moved since the last event.
class Host
{
public:
  Host(const std::string& name, Session& session)
      : window_(name + " — Contact Cookbook"),
        text_(window_.renderer, 14),
        controls_{session},
        parts_(parts_for(session, text_.there()))
  {
    fit(window_, parts_);
    SDL_ShowWindow(window_.window);
  }

  /// Until it is closed: what has happened, the steps that are due, the window.
  void run()
  {
    StepClock clock;
    while (!controls_.closed)
    {
      SDL_Event event;
      for (bool more = SDL_WaitEventTimeout(&event, clock.wait()) != 0; more;
           more = SDL_PollEvent(&event) != 0)
      {
        take(event);
      }
      move();
      advance(controls_, clock.due(4));
      draw();
    }
  }

private:
  void take(const SDL_Event& event)
  {
    switch (event.type)
    {
    case SDL_QUIT:
      controls_.closed = true;
      break;
    case SDL_KEYDOWN:
      press_key(controls_, key_name(event.key.keysym.sym));
      break;
    case SDL_MOUSEBUTTONDOWN:
      press(event.button.x, event.button.y);
      break;
    case SDL_MOUSEMOTION:
      moved_ = SDL_Point{event.motion.x, event.motion.y};
      break;
    case SDL_MOUSEBUTTONUP:
      move();
      point(event.button.x, event.button.y, "up");
      held_ = Held::nothing;
      break;
    case SDL_MOUSEWHEEL:
      turn(event.wheel.y);
      break;
    case SDL_DROPFILE:
      drop(event.drop.file);
      break;
    default:
      break;
    }
  }

  void press(int x, int y)
  {
    move();
    if (x < parts_.picture_width && y < parts_.picture_height)
    {
      held_ = Held::picture;
      point(x, y, "down");
      return;
    }
    const PanelHit hit = panel_hit(parts_, x, y);
    const std::vector<Input> inputs = offered(controls_.session);
    if (hit.row < 0 || hit.row >= int(inputs.size()))
    {
      return;
    }
    controls_.chosen = std::size_t(hit.row);
    if (inputs[controls_.chosen].kind == InputKind::slider)
    {
      held_ = Held::slider;
      slide(hit.part);
      return;
    }
    press_key(controls_, "enter");
  }

  /// What the mouse has moved since it was asked last: only its last place counts.
  void move()
  {
    if (!moved_)
    {
      return;
    }
    if (held_ == Held::slider)
    {
      slide(panel_hit(parts_, std::clamp(moved_->x, parts_.picture_width, parts_.width - 1), 1000)
                .part);
    }
    point(moved_->x, moved_->y, "move");
    moved_.reset();
  }

  /// Tells the figure of the mouse while it holds the picture.
  void point(int x, int y, const std::string& what)
  {
    if (held_ == Held::picture)
    {
      send(controls_, "pointer " + std::to_string(x) + " " + std::to_string(y) + " " + what);
    }
  }

  void turn(int wheel)
  {
    int x = 0, y = 0;
    SDL_GetMouseState(&x, &y);
    float logical_x = 0, logical_y = 0;
    SDL_RenderWindowToLogical(window_.renderer, x, y, &logical_x, &logical_y);
    if (logical_x < float(parts_.picture_width) && logical_y < float(parts_.picture_height))
    {
      send(
          controls_, "pointer " + std::to_string(logical_x) + " " + std::to_string(logical_y) +
                         " move " + std::to_string(wheel));
    }
  }

  void slide(double part)
  {
    const std::vector<Input> inputs = offered(controls_.session);
    if (controls_.chosen < inputs.size())
    {
      const Input& input = inputs[controls_.chosen];
      const double value = input.least + part * (input.most - input.least);
      send(controls_, "set " + event_name(input.name) + " " + std::to_string(value));
    }
  }

  void drop(char* file)
  {
    open_file(controls_, file);
    SDL_free(file);
  }

  void draw()
  {
    const Session& session = controls_.session;
    const bool other = session.picture_width() != parts_.picture_width ||
                       session.picture_height() != parts_.picture_height;
    if (other)
    {
      parts_ = parts_for(session, text_.there());
      fit(window_, parts_);
    }
    float scale = 1;
    SDL_RenderGetScale(window_.renderer, &scale, nullptr);
    text_.scale(double(scale));
    SDL_SetRenderDrawColor(window_.renderer, 0, 0, 0, 255);
    SDL_RenderClear(window_.renderer);
    draw_picture(window_, session);
    if (text_.there())
    {
      draw_panel(window_.renderer, text_, controls_, parts_);
    }
    SDL_RenderPresent(window_.renderer);
  }

  enum class Held
  {
    nothing,
    picture,
    slider
  };
  Window window_;
  Text text_;
  Controls controls_;
  Parts parts_;
  Held held_ = Held::nothing;
  std::optional<SDL_Point> moved_;
};

} // namespace

void run_window(const std::string& name, Session& session)
{
  const Sdl sdl;
  Host(name, session).run();
}

} // namespace cookbook::live
