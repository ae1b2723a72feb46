// app/getdp_files.c
#include "app/getdp_files.h"

#include <math.h>
#include <stdbool.h>

enum { MSH_TRIANGLE = 2, MSH_TRIANGLE_2 = 9, MSH_POINT = 15 };

// corners first, then the middles of edges 01, 12, 20, as MSH has them, in the lattice order of
// base/element.h
static const int triangle_1[1][6] = {{0, 1, 2}};
static const int triangle_2[1][6] = {{0, 2, 5, 1, 4, 3}};
static const int quad_1[2][6] = {{0, 1, 3}, {0, 3, 2}};
static const int quad_2[2][6] = {{0, 2, 8, 1, 5, 4}, {0, 8, 6, 4, 7, 3}};

static void write_block(const mesh_block *block, int order, int *number, FILE *file)
{
    const int parts = block->shape == SHAPE_QUAD ? 2 : 1, nnode = order == 2 ? 6 : 3;
    const int(*corner)[6] = block->shape == SHAPE_QUAD ? (order == 2 ? quad_2 : quad_1)
                                                       : (order == 2 ? triangle_2 : triangle_1);
    for (int e = 0; e < block->nelem; e++) {
        const int *conn = block->conn + (size_t)e * (size_t)block->per_elem;
        const int region = block->material[e] + 1;
        for (int part = 0; part < parts; part++) {
            fprintf(file, "%d %d 2 %d %d", ++*number, order == 2 ? MSH_TRIANGLE_2 : MSH_TRIANGLE,
                    region, region);
            for (int i = 0; i < nnode; i++) {
                fprintf(file, " %d", conn[corner[part][i]] + 1);
            }
            fputc('\n', file);
        }
    }
}

// the node farthest from the first one, which holds the turning of a plane body pinned there
static int farthest_node(const mesh *plane)
{
    int far = 0;
    double most = 0;
    for (int i = 1; i < plane->nnode; i++) {
        const double *x = plane->xyz + (size_t)3 * (size_t)i;
        const double distance = hypot(x[0] - plane->xyz[0], x[1] - plane->xyz[1]);
        if (distance > most) {
            most = distance;
            far = i;
        }
    }
    return far;
}

void getdp_write_mesh(const mesh *plane, FILE *file)
{
    int count = 2, number = 2;
    fprintf(file, "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n%d\n", plane->nnode);
    for (int i = 0; i < plane->nnode; i++) {
        const double *x = plane->xyz + (size_t)3 * (size_t)i;
        fprintf(file, "%d %.17g %.17g 0\n", i + 1, 1e3 * x[0], 1e3 * x[1]);
    }
    for (int b = 0; b < plane->nblock; b++) {
        count += plane->block[b].nelem * (plane->block[b].shape == SHAPE_QUAD ? 2 : 1);
    }
    fprintf(file, "$EndNodes\n$Elements\n%d\n1 %d 2 %d %d 1\n", count, MSH_POINT, GETDP_PIN,
            GETDP_PIN);
    fprintf(file, "2 %d 2 %d %d %d\n", MSH_POINT, GETDP_FAR_PIN, GETDP_FAR_PIN,
            farthest_node(plane) + 1);
    for (int b = 0; b < plane->nblock; b++) {
        write_block(&plane->block[b], plane->order, &number, file);
    }
    fprintf(file, "$EndElements\n");
}

static const char rules[] =
    "Jacobian { { Name Plane; Case { { Region All; Jacobian Vol; } } } }\n"
    "Integration { { Name Gauss; Case { { Type Gauss; Case {\n"
    "  { GeoElement Triangle; NumberOfPoints 12; } { GeoElement Triangle2; NumberOfPoints 12; }\n"
    "} } } } }\n";

static const char torsion[] =
    "Constraint { { Name Pin; Case { { Region Pin; Value 0; } } } }\n"
    "FunctionSpace { { Name W; Type Form0;\n"
    "  BasisFunction { { Name n; NameOfCoef w; Function BF_Node; Support Section;\n"
    "    Entity NodesOf[All]; } }\n"
    "  Constraint { { NameOfCoef w; EntityType NodesOf; NameOfConstraint Pin; } } } }\n"
    "Formulation { { Name Torsion; Type FemEquation;\n"
    "  Quantity { { Name w; Type Local; NameOfSpace W; } }\n"
    "  Equation {\n"
    "    Galerkin { [ G[] * Dof{d w}, {d w} ]; In Section; Jacobian Plane; Integration Gauss; }\n"
    "    Galerkin { [ G[] * r[], {d w} ]; In Section; Jacobian Plane; Integration Gauss; } } } }\n"
    "Resolution { { Name Torsion; System { { Name A; NameOfFormulation Torsion; } }\n"
    "  Operation { Generate[A]; Solve[A]; SaveSolution[A]; } } }\n"
    "PostProcessing { { Name Torsion; NameOfFormulation Torsion; Quantity { { Name GJ; Value {\n"
    "  Integral { [ G[] * SquNorm[{d w} + r[]] ]; In Section; Jacobian Plane; Integration Gauss; "
    "}\n"
    "} } } } }\n"
    "PostOperation { { Name Torsion; NameOfPostProcessing Torsion; Operation {\n"
    "  Print[ GJ[Section], OnGlobal, Format Table, File \"gj.txt\" ]; } } }\n";

static void write_groups(int nmaterial, FILE *file)
{
    fprintf(file, "Group {\n  Pin = Region[%d];\n  FarPin = Region[%d];\n  Section = Region[{",
            GETDP_PIN, GETDP_FAR_PIN);
    for (int i = 0; i < nmaterial; i++) {
        fprintf(file, "%s%d", i ? ", " : "", i + 1);
    }
    fprintf(file, "}];\n}\n");
}

void getdp_write_torsion(int nmaterial, const material *materials, FILE *file)
{
    write_groups(nmaterial, file);
    fprintf(file, "Function {\n  r[] = Vector[-Y[], X[], 0];\n");
    for (int i = 0; i < nmaterial; i++) {
        fprintf(file, "  G[Region[%d]] = %.17g;\n", i + 1,
                1e-6 * material_shear_modulus(&materials[i]));
    }
    fprintf(file, "}\n%s%s", rules, torsion);
}

// --- plane strain

// u and v are scalar fields, so that the four products of their gradients are tensors of their own
static const char space[] =
    "{ Name %c; Type Form0;\n"
    "  BasisFunction { { Name n; NameOfCoef c; Function BF_Node; Support Section;\n"
    "    Entity NodesOf[All]; } }\n"
    "  Constraint { { NameOfCoef c; EntityType NodesOf; NameOfConstraint Pin_%c; } } }\n";

// e is the strain along the rod that is given
static const char plane_formulation[] =
    "{ Name Plane%d; Type FemEquation;\n"
    "  Quantity { { Name u; Type Local; NameOfSpace u; } { Name v; Type Local; NameOfSpace v; } }\n"
    "  Equation {\n"
    "    Galerkin { [ Quu[] * Dof{d u}, {d u} ]; In Section; Jacobian Plane; Integration Gauss; }\n"
    "    Galerkin { [ Quv[] * Dof{d v}, {d u} ]; In Section; Jacobian Plane; Integration Gauss; }\n"
    "    Galerkin { [ Qvu[] * Dof{d u}, {d v} ]; In Section; Jacobian Plane; Integration Gauss; }\n"
    "    Galerkin { [ Qvv[] * Dof{d v}, {d v} ]; In Section; Jacobian Plane; Integration Gauss; }\n"
    "    Galerkin { [ lambda[] * e%d[] * Vector[1, 0, 0], {d u} ];\n"
    "      In Section; Jacobian Plane; Integration Gauss; }\n"
    "    Galerkin { [ lambda[] * e%d[] * Vector[0, 1, 0], {d v} ];\n"
    "      In Section; Jacobian Plane; Integration Gauss; } } }\n";

// resultants of the axial stress with the strains of all three loads: the energy's bilinear form,
// because the stress in the plane does no work on a field in the plane
static const char plane_quantity[] =
    "  { Name K%d%d; Value { Integral { [ e%d[] * (Qzz[] * e%d[] +\n"
    "    lambda[] * (CompX[{d u}] + CompY[{d v}])) ];\n"
    "    In Section; Jacobian Plane; Integration Gauss; } } }\n";

static void write_elasticity(int nmaterial, const material *materials, FILE *file)
{
    fprintf(file, "Function {\n  e0[] = 1;\n  e1[] = Y[];\n  e2[] = -X[];\n");
    for (int i = 0; i < nmaterial; i++) {
        const double nu = materials[i].nu, G = 1e-6 * material_shear_modulus(&materials[i]);
        const double lambda = 2 * G * nu / (1 - 2 * nu), Q = lambda + 2 * G;
        fprintf(file,
                "  lambda[Region[%d]] = %.17g;\n  Qzz[Region[%d]] = %.17g;\n"
                "  Quu[Region[%d]] = TensorDiag[%.17g, %.17g, 0];\n"
                "  Quv[Region[%d]] = Tensor[0, %.17g, 0, %.17g, 0, 0, 0, 0, 0];\n"
                "  Qvu[Region[%d]] = Tensor[0, %.17g, 0, %.17g, 0, 0, 0, 0, 0];\n"
                "  Qvv[Region[%d]] = TensorDiag[%.17g, %.17g, 0];\n",
                i + 1, lambda, i + 1, Q, i + 1, Q, G, i + 1, lambda, G, i + 1, G, lambda, i + 1, G,
                Q);
    }
    fprintf(file, "}\n");
}

// the far pin holds what turns it most
static void write_pins(const mesh *plane, FILE *file)
{
    const double *far = plane->xyz + (size_t)3 * (size_t)farthest_node(plane);
    const bool along_x = fabs(far[0] - plane->xyz[0]) >= fabs(far[1] - plane->xyz[1]);
    fprintf(file, "Constraint {\n");
    for (int i = 0; i < 2; i++) {
        fprintf(file, "{ Name Pin_%c; Case { { Region Pin; Value 0; } %s } }\n", "uv"[i],
                along_x == (i == 1) ? "{ Region FarPin; Value 0; }" : "");
    }
    fprintf(file, "}\nFunctionSpace {\n");
    fprintf(file, space, 'u', 'u');
    fprintf(file, space, 'v', 'v');
    fprintf(file, "}\n");
}

static void write_answers(FILE *file)
{
    fprintf(file, "PostProcessing {\n");
    for (int i = 0; i < 3; i++) {
        fprintf(file, "{ Name Plane%d; NameOfFormulation Plane%d; NameOfSystem A%d; Quantity {\n",
                i, i, i);
        for (int j = 0; j < 3; j++) {
            fprintf(file, plane_quantity, j, i, j, i);
        }
        fprintf(file, "} }\n");
    }
    fprintf(file, "}\nPostOperation {\n");
    for (int i = 0; i < 3; i++) {
        fprintf(file, "{ Name Plane%d; NameOfPostProcessing Plane%d; Operation {\n", i, i);
        for (int j = 0; j < 3; j++) {
            fprintf(file,
                    "  Print[ K%d%d[Section], OnGlobal, Format Table, File \"k%d%d.txt\" ];\n", j,
                    i, j, i);
        }
        fprintf(file, "} }\n");
    }
    fprintf(file, "}\n");
}

void getdp_write_plane(const mesh *plane, int nmaterial, const material *materials, FILE *file)
{
    write_groups(nmaterial, file);
    write_elasticity(nmaterial, materials, file);
    fprintf(file, "%s", rules);
    write_pins(plane, file);
    fprintf(file, "Formulation {\n");
    for (int i = 0; i < 3; i++) {
        fprintf(file, plane_formulation, i, i, i);
    }
    fprintf(file, "}\nResolution { { Name Plane; System {\n");
    for (int i = 0; i < 3; i++) {
        fprintf(file, "  { Name A%d; NameOfFormulation Plane%d; }\n", i, i);
    }
    fprintf(file, "} Operation {\n");
    for (int i = 0; i < 3; i++) {
        fprintf(file, "  Generate[A%d]; Solve[A%d]; SaveSolution[A%d];\n", i, i, i);
    }
    fprintf(file, "} } }\n");
    write_answers(file);
}
