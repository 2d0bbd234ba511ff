// SPDX-License-Identifier: MIT
// The panel, with Dear ImGui. Sliders that change the sea take effect when they are released, since creating a sea
// takes time; all others take effect at once.
#include "panel.h"

#include "bolan/io.h"
#include "messages.h"
#include "panel_rows.h"

#include <backends/imgui_impl_opengl3.h>
#include <backends/imgui_impl_sdl.h>
#include <imgui.h>

#include <cfloat>
#include <cmath>
#include <cstdio>
#include <cstring>

namespace {

const float width_in_letters = 27.0f;
float text_scale = 1.0f;

// ---- small parts ----------------------------------------------------------------------------------------------------

const ImGuiSliderFlags clamp = ImGuiSliderFlags_AlwaysClamp;

panel_row rows[PANEL_ROW_COUNT];

ImGuiSliderFlags flags_of(const panel_row &row) {
    return row.logarithmic ? clamp | ImGuiSliderFlags_Logarithmic : clamp;
}

// A slider over a factor that is no parameter of a scene.
void slide_factor(const char *label, double *value, double low, double high, const char *format) {
    ImGui::SliderScalar(label, ImGuiDataType_Double, value, &low, &high, format, clamp | ImGuiSliderFlags_Logarithmic);
}

// A slider over a field of the scene.
void slide(panel_row_id id, double *field) {
    const panel_row &row = rows[id];
    double value = *field / row.factor;
    if (ImGui::SliderScalar(row.label, ImGuiDataType_Double, &value, &row.low, &row.high, row.format, flags_of(row)))
        *field = value * row.factor;
}

// A slider over a knob, in units of the row. Returns true when it is released at a new value.
bool let_go(panel_row_id id, float *value) {
    const panel_row &row = rows[id];
    ImGui::SliderFloat(row.label, value, static_cast<float>(row.low), static_cast<float>(row.high), row.format,
                       flags_of(row));
    return ImGui::IsItemDeactivatedAfterEdit();
}

unsigned group(bool changed, sea_knob_group bit) { return changed ? static_cast<unsigned>(bit) : 0u; }

bool begin_combo(const char *label, const char *shown) {
    return ImGui::BeginCombo(label, shown, ImGuiComboFlags_HeightLarge);
}

const char *compass(double degrees) {
    static const char *const names[] = {"N", "NNE", "NE", "ENE", "E", "ESE", "SE", "SSE",
                                        "S", "SSW", "SW", "WSW", "W", "WNW", "NW", "NNW"};
    return names[static_cast<int>(std::floor(degrees / 22.5 + 0.5)) & 15];
}

// ---- sections -------------------------------------------------------------------------------------------------------

void scene_list(const bolan_scene *scene, panel_wishes *wishes) {
    if (!begin_combo("scene", scene->name)) return;
    const char *name;
    for (uint32_t i = 0; (name = bolan_scene_builtin_name(i)) != nullptr; ++i)
        if (ImGui::Selectable(name, std::strcmp(name, scene->name) == 0)) wishes->scene = name;
    ImGui::EndCombo();
}

void time_controls(const panel_edits *e, const panel_facts *f) {
    if (ImGui::Button(*e->paused ? "run" : "pause", ImVec2(ImGui::GetFontSize() * 4.0f, 0.0f)))
        *e->paused = !*e->paused;
    ImGui::SameLine();
    ImGui::Text("%.1f s", f->time);
    slide_factor("time scale", e->time_scale, 0.0625, 16.0, "%.3gx");
}

unsigned sea_preset(sea_knobs *k) {
    unsigned changed = 0;
    if (begin_combo("sea state", "Douglas...")) {
        for (int d = 0; d < 10; ++d) {
            char line[64];
            std::snprintf(line, sizeof line, "%d  %s", d, bolan_douglas_table[d].name);
            if (!ImGui::Selectable(line)) continue;
            k->wind_speed = static_cast<float>(bolan_sea_state_from_douglas(d, k->wind_from).wind_speed);
            k->fetch_km = SEA_KNOBS_FETCH_MAX;
            changed = SEA_KNOBS_WIND;
        }
        ImGui::EndCombo();
    }
    if (begin_combo("wind force", "Beaufort...")) {
        for (int b = 0; b < 13; ++b) {
            char line[64];
            std::snprintf(line, sizeof line, "%2d  %s", b, bolan_beaufort_table[b].name);
            if (!ImGui::Selectable(line)) continue;
            k->wind_speed = static_cast<float>(bolan_sea_state_from_beaufort(b, k->wind_from).wind_speed);
            changed = SEA_KNOBS_WIND;
        }
        ImGui::EndCombo();
    }
    return changed;
}

unsigned swell_section(sea_knobs *k) {
    unsigned changed = group(ImGui::Checkbox("swell", &k->swell), SEA_KNOBS_SWELL);
    if (!k->swell) return changed;
    bool turned = let_go(ROW_SWELL_HEIGHT, &k->swell_height);
    turned |= let_go(ROW_SWELL_PERIOD, &k->swell_period);
    turned |= let_go(ROW_SWELL_FROM, &k->swell_from);
    turned |= let_go(ROW_SWELL_SPREAD, &k->swell_spread);
    return changed | group(turned, SEA_KNOBS_SWELL);
}

unsigned sea_section(const panel_edits *e, const panel_facts *f) {
    if (!ImGui::CollapsingHeader("Sea", ImGuiTreeNodeFlags_DefaultOpen)) return 0;
    sea_knobs *k = e->knobs;
    ImGui::Text("Hs %.2f m   Tp %.1f s   from %.0f %s", f->sea.hs, f->sea.tp, f->sea.direction_from,
                compass(f->sea.direction_from));
    unsigned changed = 0;
    if (k->measured)
        ImGui::TextWrapped("Measured spectrum %s: the wind here only roughens it.", e->scene->spectrum_path);
    else
        changed |= sea_preset(k);
    bool wind = let_go(ROW_WIND_SPEED, &k->wind_speed);
    wind |= let_go(ROW_WIND_FROM, &k->wind_from);
    if (!k->measured) wind |= let_go(ROW_FETCH, &k->fetch_km);
    changed |= group(wind, SEA_KNOBS_WIND) | swell_section(k);
    bool layout = let_go(ROW_CHOPPINESS, &k->choppiness);
    layout |= ImGui::Checkbox("second order", &k->second_order);
    ImGui::InputInt("seed", &k->seed);
    layout |= ImGui::IsItemDeactivatedAfterEdit();
    if (k->seed < 0) k->seed = 0;
    return changed | group(layout, SEA_KNOBS_LAYOUT);
}

void sky_section(bolan_sky *sky) {
    if (!ImGui::CollapsingHeader("Sun and sky", ImGuiTreeNodeFlags_DefaultOpen)) return;
    slide(ROW_SUN_AZIMUTH, &sky->sun_azimuth_deg);
    slide(ROW_SUN_ELEVATION, &sky->sun_elevation_deg);
    slide(ROW_VISIBILITY, &sky->visibility);
    slide(ROW_CLOUD_COVER, &sky->cloud_cover);
    slide(ROW_CLOUD_BASE, &sky->cloud_base);
}

unsigned water_section(const panel_edits *e) {
    if (!ImGui::CollapsingHeader("Water", ImGuiTreeNodeFlags_DefaultOpen)) return 0;
    bolan_seawater *water = &e->scene->water;
    if (begin_combo(rows[ROW_WATER_TYPE].label, bolan_jerlov_name(water->type))) {
        for (int t = 0; t < BOLAN_JERLOV_TYPES; ++t)
            if (ImGui::Selectable(bolan_jerlov_name(static_cast<bolan_jerlov>(t)), t == water->type))
                water->type = static_cast<bolan_jerlov>(t);
        ImGui::EndCombo();
    }
    slide(ROW_FOAM, &water->foam);
    bool lasting = let_go(ROW_FOAM_DECAY, &e->knobs->foam_decay);
    return group(lasting, SEA_KNOBS_LAYOUT);
}

bool technique_list(bolan_scene *scene) {
    bool changed = false;
    if (!begin_combo("technique", scene->technique.name)) return false;
    uint32_t count = 0;
    const bolan_technique *all = bolan_techniques(&count);
    for (uint32_t i = 0; i < count; ++i)
        if (ImGui::Selectable(all[i].name, std::strcmp(all[i].name, scene->technique.name) == 0)) {
            bolan_scene_set_technique(scene, &all[i]);
            changed = true;
        }
    ImGui::EndCombo();
    return changed;
}

unsigned technique_section(const panel_edits *e, panel_wishes *wishes) {
    if (!ImGui::CollapsingHeader("Technique and quality")) return 0;
    bool layout = technique_list(e->scene);
    int quality = static_cast<int>(*e->quality);
    if (ImGui::Combo("quality", &quality, bolan_quality_names, BOLAN_QUALITIES)) {
        *e->quality = static_cast<bolan_quality>(quality);
        wishes->quality = true;
    }
    static const char *const scales[] = {"automatic", "100 %", "75 %", "60 %", "50 %", "40 %", "33 %", "25 %"};
    static const double values[] = {0.0, 1.0, 0.75, 0.6, 0.5, 0.4, 0.33, 0.25};
    int chosen = 0;
    for (int i = 1; i < 8; ++i)
        if (std::fabs(*e->render_scale - values[i]) < 1e-3) chosen = i;
    if (ImGui::Combo("resolution", &chosen, scales, 8)) *e->render_scale = values[chosen];
    static const char *const sizes[] = {"64", "128", "256", "512", "1024"};
    int size = 0;
    while (size < 4 && (64 << size) < e->knobs->resolution) ++size;
    if (ImGui::Combo(rows[ROW_RESOLUTION].label, &size, sizes, 5)) {
        e->knobs->resolution = 64 << size;
        layout = true;
    }
    const panel_row &cascades = rows[ROW_CASCADES];
    ImGui::SliderInt(cascades.label, &e->knobs->cascades, static_cast<int>(cascades.low),
                     static_cast<int>(cascades.high), "%d", clamp);
    layout |= ImGui::IsItemDeactivatedAfterEdit();
    return group(layout, SEA_KNOBS_LAYOUT);
}

void camera_section(const panel_edits *e, const panel_facts *f, panel_wishes *wishes) {
    if (!ImGui::CollapsingHeader("Camera", ImGuiTreeNodeFlags_DefaultOpen)) return;
    bolan_camera *c = &e->scene->camera;
    ImGui::Text("east %.1f  north %.1f  up %.1f m", c->position.x, c->position.y, c->position.z);
    ImGui::Text("heading %.0f %s  pitch %+.1f deg", c->heading_deg, compass(c->heading_deg), c->pitch_deg);
    ImGui::Text("%.1f m over the %s, %.1f m/s", f->camera_height, f->over_land ? "ground" : "water", f->camera_speed);
    slide(ROW_FIELD_OF_VIEW, &c->fov_deg);
    slide_factor("speed", e->speed, 0.02, 50.0, "%.2gx");
    slide(ROW_EXPOSURE, &e->scene->exposure);
    if (ImGui::Button("back to the scene's view")) wishes->home = true;
}

void pass_row(const char *name, double ms, double total) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(name);
    ImGui::TableNextColumn();
    ImGui::Text("%6.2f", ms);
    ImGui::TableNextColumn();
    ImGui::ProgressBar(total > 0.0 ? static_cast<float>(ms / total) : 0.0f,
                       ImVec2(-FLT_MIN, ImGui::GetFontSize() * 0.8f), "");
}

void frame_section(const panel_facts *f, panel_wishes *wishes) {
    ImGui::Text("%.1f frames/s  %.1f ms  %u x %u", f->frame_ms > 0.0 ? 1e3 / f->frame_ms : 0.0, f->frame_ms,
                f->picture_width, f->picture_height);
    if (f->refined[0] != '\0') ImGui::TextUnformatted(f->refined);
    if (!ImGui::CollapsingHeader("Time per pass")) return;
    wishes->measuring = true;
    if (ImGui::BeginTable("passes", 3, ImGuiTableFlags_SizingStretchProp)) {
        pass_row("synthesis", f->synthesis_ms, f->frame_ms);
        for (uint32_t i = 0; i < f->statistics.pass_count; ++i)
            pass_row(f->statistics.passes[i].name, f->statistics.passes[i].ms, f->frame_ms);
        ImGui::EndTable();
    }
    ImGui::Text("%u triangles, %u of them water", f->statistics.triangles, f->statistics.water_triangles);
    ImGui::TextWrapped("%s", f->device);
}

void message_section(const panel_facts *f, panel_wishes *wishes) {
    if (ImGui::Button("screenshot (F12)")) wishes->screenshot = true;
    if (f->shader_directory != nullptr) {
        ImGui::SameLine();
        if (ImGui::Button("reload shaders (F5)")) wishes->reload = true;
    }
    if (messages_get(0) == nullptr) return;
    if (!ImGui::CollapsingHeader("Messages", ImGuiTreeNodeFlags_DefaultOpen)) return;
    const char *line;
    for (unsigned i = 0; (line = messages_get(i)) != nullptr; ++i) {
        ImGui::PushStyleColor(ImGuiCol_Text, i == 0 ? ImVec4(1.0f, 0.75f, 0.5f, 1.0f) : ImVec4(0.7f, 0.7f, 0.7f, 1.0f));
        ImGui::TextWrapped("%s", line);
        ImGui::PopStyleColor();
    }
    if (ImGui::SmallButton("clear")) messages_clear();
}

void keys_section() {
    if (!ImGui::CollapsingHeader("Keys")) return;
    ImGui::TextUnformatted("drag, or Tab    look around\n"
                           "WASD, arrows    move\n"
                           "Q E             down, up\n"
                           "Shift, Ctrl     faster, slower\n"
                           "wheel           speed\n"
                           "Space  + -      pause, time scale\n"
                           "Home            the scene's view\n"
                           "F1 panel   F5 reload   F11 full\n"
                           "F12 screenshot   Esc quit");
}

// ---- the whole ------------------------------------------------------------------------------------------------------

void draw_panel(const panel_edits *e, const panel_facts *f, panel_wishes *wishes) {
    const float letter = ImGui::GetFontSize(), width = letter * width_in_letters;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(letter * 0.75f, letter * 0.75f), ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0.0f),
                                        ImVec2(width, std::fmax(screen.y - letter * 1.5f, letter * 8.0f)));
    if (ImGui::Begin("Bolan  (F1 hides)", e->visible, ImGuiWindowFlags_AlwaysAutoResize)) {
        ImGui::PushItemWidth(letter * 14.5f);
        scene_list(e->scene, wishes);
        frame_section(f, wishes);
        time_controls(e, f);
        message_section(f, wishes);
        wishes->sea |= sea_section(e, f);
        sky_section(&e->scene->sky);
        wishes->sea |= water_section(e);
        wishes->sea |= technique_section(e, wishes);
        camera_section(e, f, wishes);
        keys_section();
        ImGui::PopItemWidth();
    }
    ImGui::End();
}

void draw_notice(const char *notice) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(screen.x * 0.5f, screen.y - ImGui::GetFontSize()), ImGuiCond_Always,
                            ImVec2(0.5f, 1.0f));
    ImGui::SetNextWindowBgAlpha(0.7f);
    const ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                                   ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoFocusOnAppearing |
                                   ImGuiWindowFlags_NoNav;
    if (ImGui::Begin("notice", nullptr, flags)) ImGui::TextUnformatted(notice);
    ImGui::End();
}

void set_style() {
    ImGui::StyleColorsDark();
    ImGuiStyle &style = ImGui::GetStyle();
    style.WindowRounding = 4.0f;
    style.FrameRounding = 2.0f;
    style.Colors[ImGuiCol_WindowBg] = ImVec4(0.05f, 0.07f, 0.09f, 0.82f);
    style.ScaleAllSizes(text_scale);
}

} // namespace

bool panel_open(const window *w) {
    panel_rows_make(rows);
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO &io = ImGui::GetIO();
    io.IniFilename = nullptr; // writes no file into the folder of the user
    text_scale = window_text_scale(w);
    ImFontConfig font;
    const float density = window_density(w);
    font.SizePixels = std::floor(13.0f * text_scale * density + 0.5f);
    io.FontGlobalScale = 1.0f / density;
    io.Fonts->AddFontDefault(&font);
    set_style();
    if (ImGui_ImplSDL2_InitForOpenGL(w->handle, w->context)) {
        if (ImGui_ImplOpenGL3_Init(w->es ? "#version 300 es" : "#version 330 core")) return true;
        ImGui_ImplSDL2_Shutdown();
    }
    std::fprintf(stderr, "bolan: the panel cannot be set up on this display\n");
    ImGui::DestroyContext();
    return false;
}

void panel_close(void) {
    if (ImGui::GetCurrentContext() == nullptr) return;
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplSDL2_Shutdown();
    ImGui::DestroyContext();
}

void panel_event(const SDL_Event *event) { ImGui_ImplSDL2_ProcessEvent(event); }

void panel_taken(bool *mouse, bool *keyboard) {
    const ImGuiIO &io = ImGui::GetIO();
    *mouse = io.WantCaptureMouse;
    *keyboard = io.WantTextInput; // a clicked slider must not take W, A, S and D
}

panel_wishes panel_draw(const panel_edits *edits, const panel_facts *facts) {
    panel_wishes wishes = {};
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplSDL2_NewFrame();
    ImGui::NewFrame();
    if (*edits->visible) draw_panel(edits, facts, &wishes);
    if (facts->notice != nullptr) draw_notice(facts->notice);
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    return wishes;
}
