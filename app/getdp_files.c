// app/getdp_files.c
#include "app/getdp_files.h"

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

void getdp_write_mesh(const mesh *plane, FILE *file)
{
    int count = 1, number = 1;
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
    for (int b = 0; b < plane->nblock; b++) {
        write_block(&plane->block[b], plane->order, &number, file);
    }
    fprintf(file, "$EndElements\n");
}

static const char problem[] =
    "Jacobian { { Name Plane; Case { { Region All; Jacobian Vol; } } } }\n"
    "Integration { { Name Gauss; Case { { Type Gauss; Case {\n"
    "  { GeoElement Triangle; NumberOfPoints 12; } { GeoElement Triangle2; NumberOfPoints 12; }\n"
    "} } } } }\n"
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

void getdp_write_problem(int nmaterial, const material *materials, FILE *file)
{
    fprintf(file, "Group {\n  Pin = Region[%d];\n  Section = Region[{", GETDP_PIN);
    for (int i = 0; i < nmaterial; i++) {
        fprintf(file, "%s%d", i ? ", " : "", i + 1);
    }
    fprintf(file, "}];\n}\nFunction {\n  r[] = Vector[-Y[], X[], 0];\n");
    for (int i = 0; i < nmaterial; i++) {
        fprintf(file, "  G[Region[%d]] = %.17g;\n", i + 1,
                1e-6 * material_shear_modulus(&materials[i]));
    }
    fprintf(file, "}\n%s", problem);
}
