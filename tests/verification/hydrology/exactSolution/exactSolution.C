/*---------------------------------------------------------------------------*\
    slideFoam | from rain to runout
    Copyright (C) 2026 the slideFoam authors
-------------------------------------------------------------------------------
License
    This file is part of slideFoam.

    slideFoam is free software: you can redistribute it and/or modify it
    under the terms of the GNU General Public License as published by the
    Free Software Foundation, either version 3 of the License, or (at your
    option) any later version.

    slideFoam is distributed in the hope that it will be useful, but WITHOUT
    ANY WARRANTY; without even the implied warranty of MERCHANTABILITY or
    FITNESS FOR A PARTICULAR PURPOSE. See the GNU General Public License for
    more details.

    You should have received a copy of the GNU General Public License along
    with slideFoam. If not, see <http://www.gnu.org/licenses/>.

Application
    exactSolution

Description
    A case beside its solution in closed form: sets the field at the start, or
    says how far the solver's field is from it.

Usage
    \b exactSolution [OPTION]

    Options:
      - \par -set
        Set psi in the cells and on the patches of type fixedValue, or h on the
        ground, to the solution at the start time; and evaluate the differential
        equation at the cells and selected times, by differences.

    Psi is taken at the centres of cells, h as the mean over each face.

    Without it the error at the selected times (default: the last) is printed,
    weighted by volume or plan area:
    \verbatim
        error 3600: mean 1.2e-4 rms 2.0e-4 largest 1.1e-3 [m]
    \endverbatim

    system/exactSolutionDict names the solution, see exactField.

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "faMesh.H"
#include "areaFields.H"
#include "timeSelector.H"
#include "gravityMeshObject.H"
#include "exactField.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Places with x along the mesh's x and z against gravity
static vectorField upright(const UList<point>& points, const vector& up)
{
    const vector x(1, 0, 0);
    const vector y(up ^ x);

    vectorField result(points.size());
    forAll(points, i)
    {
        result[i] = vector(points[i].x(), points[i] & y, points[i] & up);
    }
    return result;
}


//- Values of the solution
static scalarField values
(
    const exactField& exact,
    const vectorField& places,
    const scalar t
)
{
    scalarField result(places.size());
    forAll(places, i)
    {
        result[i] = exact.value(places[i], t);
    }
    return result;
}


//- Integral of the solution over a triangle seen from above, by parts until it
//  is linear in each
static scalar integral
(
    const exactField& exact,
    const FixedList<point, 3>& corners,
    const scalar t,
    const label nHalvings
)
{
    // A part is taken for linear where its middle is that close to the mean of
    // its corners, relatively
    const scalar close = 1e-4;

    const point middle((corners[0] + corners[1] + corners[2])/3);
    const scalar atMiddle = exact.value(middle, t);
    const scalar atCorners =
    (
        exact.value(corners[0], t)
      + exact.value(corners[1], t)
      + exact.value(corners[2], t)
    )/3;

    if (nHalvings == 0 || mag(atMiddle - atCorners) <= close*mag(atCorners))
    {
        const vector twice
        (
            (corners[1] - corners[0]) ^ (corners[2] - corners[0])
        );

        return 0.5*mag(twice.z())*(0.75*atMiddle + 0.25*atCorners);
    }

    const FixedList<point, 3> halves
    ({
        0.5*(corners[1] + corners[2]),
        0.5*(corners[2] + corners[0]),
        0.5*(corners[0] + corners[1])
    });

    scalar sum = integral(exact, halves, t, nHalvings - 1);
    for (label i = 0; i < 3; ++i)
    {
        const FixedList<point, 3> part
        ({
            corners[i],
            halves[(i + 1) % 3],
            halves[(i + 2) % 3]
        });
        sum += integral(exact, part, t, nHalvings - 1);
    }
    return sum;
}


//- Means of the solution over faces of the ground: what a finite volume knows.
//  In the face with the edge of the water the value at the centre is another one
static scalarField groundMeans
(
    const exactField& exact,
    const faMesh& aMesh,
    const vector& up,
    const scalar t
)
{
    // The edge is steep: 32 parts along each side of a triangle
    const label nHalvings = 5;

    const vectorField centres(upright(aMesh.areaCentres().primitiveField(), up));
    const vectorField corners(upright(aMesh.points(), up));

    scalarField result(aMesh.nFaces());
    forAll(result, facei)
    {
        const face& f = aMesh.faces()[facei];
        scalar sum = 0;
        scalar area = 0;

        forAll(f, i)
        {
            const FixedList<point, 3> triangle
            ({
                centres[facei],
                corners[f[i]],
                corners[f.nextLabel(i)]
            });
            const vector twice
            (
                (triangle[1] - triangle[0]) ^ (triangle[2] - triangle[0])
            );

            area += 0.5*mag(twice.z());
            sum += integral(exact, triangle, t, nHalvings);
        }
        result[facei] = sum/area;
    }
    return result;
}


//- Print the largest residual of the differential equation
static void printResidual
(
    const exactField& exact,
    const vectorField& places,
    const scalar t
)
{
    scalar largest = 0;
    for (const vector& place : places)
    {
        largest = max(largest, exact.residual(place, t));
    }
    Info<< "residual " << t << ": largest "
        << returnReduce(largest, maxOp<scalar>()) << nl;
}


//- Print the norms of a field's error
static void printErrors
(
    const scalarField& field,
    const scalarField& reference,
    const scalarField& weights,
    const scalar t
)
{
    const scalarField error(mag(field - reference));
    const scalar all = gSum(weights);

    Info<< "error " << t << ": mean " << gSum(weights*error)/all
        << " rms " << Foam::sqrt(gSum(weights*sqr(error))/all)
        << " largest " << gMax(error) << " [m]" << nl;
}


//- A field's file that must be there
static IOobject stored(const word& name, const objectRegistry& db)
{
    return IOobject
    (
        name,
        db.time().timeName(),
        db,
        IOobject::MUST_READ,
        IOobject::NO_WRITE
    );
}


// * * * * * * * * * * * * * * * * * Main  * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Set a field to a solution in closed form, or compare it with that"
    );
    timeSelector::addOptions(false, true);
    argList::addBoolOption
    (
        "set",
        "Set the field at the start time and check the formula"
    );

    #include "setRootCase.H"
    #include "createTime.H"

    const IOdictionary dict
    (
        IOobject
        (
            "exactSolutionDict",
            runTime.system(),
            runTime,
            IOobject::MUST_READ,
            IOobject::NO_WRITE
        )
    );
    const autoPtr<exactField> exact(exactField::New(dict));

    // The options' times, without them the last
    instantList times(timeSelector::select0(runTime, args));
    if (!args.found("time") && !args.found("noZero") && times.size())
    {
        times = instantList(1, times.last());
    }
    const bool isSet = args.found("set");
    if (isSet)
    {
        runTime.setTime(runTime.startTime(), 0);
    }

    #include "createMesh.H"

    const vector g(meshObjects::gravity::New(runTime).value());
    const vector up(-g/mag(g));

    autoPtr<faMesh> aMesh;
    scalarField weights(mesh.V().field());
    vectorField places(upright(mesh.cellCentres(), up));
    if (exact->onGround())
    {
        aMesh.reset(new faMesh(mesh));
        weights = aMesh->S().field()
           *mag(aMesh->faceAreaNormals().primitiveField() & up);
        places = upright(aMesh->areaCentres().primitiveField(), up);
    }

    const auto solution = [&](const scalar t)
    {
        return
            exact->onGround()
          ? groundMeans(*exact, *aMesh, up, t)
          : values(*exact, places, t);
    };

    if (isSet)
    {
        const scalar start = runTime.startTime().value();
        const scalarField initial(solution(start));

        if (exact->onGround())
        {
            areaScalarField field
            (
                IOobject
                (
                    exact->fieldName(),
                    runTime.timeName(),
                    aMesh->thisDb()
                ),
                *aMesh,
                dimensionedScalar(dimLength, Zero)
            );
            field.primitiveFieldRef() = initial;
            field.correctBoundaryConditions();
            field.write();
        }
        else
        {
            volScalarField field(stored(exact->fieldName(), mesh), mesh);
            field.primitiveFieldRef() = initial;
            for (fvPatchScalarField& patch : field.boundaryFieldRef())
            {
                if (patch.type() == fixedValueFvPatchScalarField::typeName)
                {
                    patch == values
                    (
                        *exact,
                        upright(patch.patch().Cf(), up),
                        start
                    );
                }
            }
            field.write();
        }

        for (const scalar t : dict.get<scalarList>("residualTimes"))
        {
            printResidual(*exact, places, t);
        }
    }
    else
    {
        for (const instant& time : times)
        {
            runTime.setTime(time, 0);
            const scalarField reference(solution(runTime.value()));
            const word name(exact->fieldName());

            printErrors
            (
                exact->onGround()
              ? areaScalarField(stored(name, aMesh->thisDb()), *aMesh)
               .primitiveField()
              : volScalarField(stored(name, mesh), mesh).primitiveField(),
                reference,
                weights,
                runTime.value()
            );
        }
    }

    Info<< nl << "End" << nl << endl;

    return 0;
}

// ************************************************************************* //
