// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A cell as one rank hands it to another.
#include "coupling/mapping/mesh/copiedCell.H"

namespace Foam
{
namespace nscdCoupling
{
namespace
{

void write(const Vec3& x, std::vector<double>& message)
{
    message.insert(message.end(), x.data(), x.data() + 3);
}

Vec3 readVec3(const double*& at)
{
    const Vec3 x(at[0], at[1], at[2]);
    at += 3;
    return x;
}

label readLabel(const double*& at)
{
    return label(*at++);
}

void write(const CopiedFace& face, std::vector<double>& message)
{
    for (const label number : {face.name.rank, face.name.face, face.behind.rank, face.behind.cell})
    {
        message.push_back(number);
    }
    write(face.shift, message);
    message.push_back(face.sign);
    message.push_back(double(face.pieces.size()));
    for (const FacePiece& piece : face.pieces)
    {
        write(piece.normal, message);
        message.push_back(piece.offset);
        message.push_back(piece.nVertices);
        for (label k = 0; k < piece.nVertices; ++k) write(face.vertices[piece.firstVertex + k], message);
    }
}

FacePiece readPiece(const double*& at, std::vector<Vec3>& vertices)
{
    FacePiece piece;
    piece.normal = readVec3(at);
    piece.offset = *at++;
    piece.nVertices = readLabel(at);
    piece.firstVertex = label(vertices.size());
    for (label k = 0; k < piece.nVertices; ++k) vertices.push_back(readVec3(at));
    return piece;
}

CopiedFace readFace(const double*& at)
{
    CopiedFace face;
    face.name.rank = readLabel(at);
    face.name.face = readLabel(at);
    face.behind.rank = readLabel(at);
    face.behind.cell = readLabel(at);
    face.shift = readVec3(at);
    face.sign = *at++;
    face.pieces.resize(readLabel(at));
    for (FacePiece& piece : face.pieces) piece = readPiece(at, face.vertices);
    return face;
}

} // namespace

Eigen::AlignedBox3d CopiedFace::box() const
{
    Eigen::AlignedBox3d result;
    for (const Vec3& vertex : vertices) result.extend(vertex);
    return result;
}

void write(const CopiedCell& cell, std::vector<double>& message)
{
    message.push_back(cell.home.rank);
    message.push_back(cell.home.cell);
    write(cell.center, message);
    message.push_back(cell.volume);
    message.push_back(double(cell.faces.size()));
    for (const CopiedFace& face : cell.faces) write(face, message);
}

CopiedCell readCell(const double*& at)
{
    CopiedCell cell;
    cell.home.rank = readLabel(at);
    cell.home.cell = readLabel(at);
    cell.center = readVec3(at);
    cell.volume = *at++;
    cell.faces.resize(readLabel(at));
    for (CopiedFace& face : cell.faces) face = readFace(at);
    return cell;
}

} // namespace nscdCoupling
} // namespace Foam
