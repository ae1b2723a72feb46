// fem/segment_faces.c
// What a case says of faces and of the tip, as a segment_problem has it.
#include "fem/segment.h"

#include <math.h>

// the choices of the key `face` begin with the base
face_part segment_face_part(int face, const double range[2])
{
    return (face_part){.face = FACE_BASE + face, .from = range[0], .to = range[1]};
}

face_pressure segment_face_pressure(const segment_pressure *p)
{
    return (face_pressure){
        .on = segment_face_part(p->face, p->range),
        .pressure = p->pressure,
        .traction = {p->traction[0], p->traction[1], p->traction[2]},
    };
}

face_spring segment_face_spring(const segment_spring *s)
{
    return (face_spring){
        .on = segment_face_part(s->face, s->range),
        .stiffness = {s->normal, s->tangential, s->tangential},
    };
}

face_hold segment_face_hold(const segment_hold *h)
{
    face_hold out = {.on = segment_face_part(h->face, h->range)};
    for (int d = 0; d < 3; d++) {
        const double motion = h->motion.nrow > 0 ? h->motion.a[d] : NAN;
        if (!isnan(motion)) {
            out.mask |= 1 << d;
            out.motion[d] = motion;
        }
    }
    return out;
}

bool segment_tip_motion(const segment_load *load, double motion[6])
{
    const key_rows *given[2] = {&load->tip_motion.translation, &load->tip_motion.rotation};
    bool any = false;
    for (int i = 0; i < 6; i++) {
        motion[i] = given[i / 3]->nrow > 0 ? given[i / 3]->a[i % 3] : NAN;
        any = any || !isnan(motion[i]);
    }
    return any;
}
