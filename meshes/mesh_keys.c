// meshes/mesh_keys.c
#include "meshes/mesher.h"

// a size beyond this is most likely a mistake of unit
#define LARGEST_LENGTH 1e6

#define COUNT(keys) ((int)(sizeof(keys) / sizeof *(keys)))

static const key mesh_key_list[] = {
    {.name = "kind",
     .kind = KEY_CHOICE,
     .choices = "auto|mapped|free",
     .initial = "auto",
     .offset = offsetof(mesh_options, kind),
     .about = "mapped: quads on a polar or Cartesian grid of the outlines' own edges; free: "
              "curved triangles of any outlines; auto: mapped where the outlines allow it"},
    {.name = "order",
     .kind = KEY_INTEGER,
     .max = ELEMENT_MAX_ORDER,
     .initial = "0",
     .offset = offsetof(mesh_options, order),
     .about = "polynomial order of the elements and of their curved edges; 0: chosen by "
              "section.tolerance, 4, of images 2, without it"},
    {.name = "size",
     .kind = KEY_REAL,
     .dimension = DIM_LENGTH,
     .min = 0,
     .max = LARGEST_LENGTH,
     .initial = "0",
     .offset = offsetof(mesh_options, size),
     .about = "target edge length; 0: chosen from the outlines"},
};

static const mesh_options mesh_initial = {.kind = MESH_AUTO};

const key_table mesh_keys = {.name = "mesh",
                             .size = sizeof(mesh_options),
                             .nkey = COUNT(mesh_key_list),
                             .keys = mesh_key_list,
                             .initial = &mesh_initial,
                             .about = "how the section is divided into elements"};

mesh_options mesh_options_default(void)
{
    mesh_options options = mesh_initial;
    mesh_options_resolve(&options);
    return options;
}

void mesh_options_resolve(mesh_options *options)
{
    if (options->order == 0) {
        options->order = ELEMENT_MAX_ORDER;
        options->order_chosen = true;
    }
}
