// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Copies of other ranks' cells around the cells of this rank.
#include "coupling/mapping/mesh/boxTree.H"
#include "coupling/mapping/mesh/meshHalo.H"
#include "coupling/mapping/mesh/ownCells.H"

#include "parallel/communicator.hpp"

#include <map>

namespace Foam
{
namespace nscdCoupling
{
namespace
{

// On top of the reach, over the size of the own cell: walks of sample points stray a little, and centers lie on borders.
constexpr scalar skin = 0.25;

// Boxes of the own cells at borders of any kind, larger by the reach: a ball that leaves the own cells passes one of these.
BoxTree boxesWithin(const fvMesh& fvMesh, const MappingMesh& mesh, const scalar reach)
{
    std::vector<Eigen::AlignedBox3d> boxes;
    for (label cell = 0; cell < mesh.nCells(); ++cell)
    {
        bool isAtBorder = false;
        Eigen::AlignedBox3d box;
        for (label k = mesh.cellFaceStart[cell]; k < mesh.cellFaceStart[cell + 1]; ++k)
        {
            isAtBorder = isAtBorder || !fvMesh.isInternalFace(mesh.cellFaces[k].face);
            box.extend(mesh.faceBox[mesh.cellFaces[k].face]);
        }
        if (isAtBorder)
        {
            const Vec3 more = Vec3::Constant(reach) + skin*box.sizes();
            boxes.emplace_back(box.min() - more, box.max() + more);
        }
    }
    return BoxTree(boxes);
}

// Visits cells outwards from the own ones and asks their ranks for those that are missing.
class HaloSearch
{
public:
    HaloSearch(const OwnCells& own, const BoxTree& within, const scalar samePlace)
    :
        own_(own),
        within_(within),
        samePlace_(samePlace)
    {}

    // The own cells that border on other ranks, or on own cells through cyclic patches.
    void start(const std::vector<label>& cells)
    {
        for (const label cell : cells) visitFaces(own_.copy(cell), Vec3::Zero());
    }

    // Collective.
    void run(const ::nscd::Communicator& ranks)
    {
        do visitAll(); while (fetchMissing(ranks));
    }

    const std::map<CellHome, CopiedCell>& halo() const { return halo_; }

private:
    // A cell as the ball's rank sees it: at its place at home less `offset`.
    struct Visit
    {
        CellHome cell;
        Vec3 offset;
    };

    void visitAll()
    {
        while (!toVisit_.empty())
        {
            const Visit visit = toVisit_.back();
            toVisit_.pop_back();
            if (visit.cell.rank == Pstream::myProcNo())
            {
                visitFaces(own_.copy(visit.cell.cell), visit.offset);
            }
            else if (const auto known = halo_.find(visit.cell); known != halo_.end())
            {
                visitFaces(known->second, visit.offset);
            }
            else
            {
                missing_[visit.cell].push_back(visit.offset);
            }
        }
    }

    void visitFaces(const CopiedCell& cell, const Vec3& offset)
    {
        for (const CopiedFace& face : cell.faces)
        {
            if (face.behind.rank >= 0 && within_.meets(face.box().translate(-offset)))
            {
                reach({face.behind, offset + face.shift});
            }
        }
    }

    void reach(const Visit& visit)
    {
        if (visit.cell.rank == Pstream::myProcNo() && visit.offset.norm() < samePlace_)
        {
            return;
        }
        std::vector<Vec3>& seen = seen_[visit.cell];
        for (const Vec3& offset : seen)
        {
            if ((offset - visit.offset).norm() < samePlace_)
            {
                return;
            }
        }
        seen.push_back(visit.offset);
        toVisit_.push_back(visit);
    }

    bool fetchMissing(const ::nscd::Communicator& ranks)
    {
        scalar nMissing = scalar(missing_.size());
        ranks.sum(&nMissing, 1);
        if (nMissing == 0)
        {
            return false;
        }
        std::vector<label> wanted;
        std::vector<int> owners;
        for (const auto& [home, offsets] : missing_)
        {
            wanted.push_back(home.cell);
            owners.push_back(home.rank);
        }
        std::vector<::nscd::Message> answers;
        for (const ::nscd::Message& request : ranks.exchange(::nscd::messagesByRank(wanted, owners)))
        {
            answers.push_back(answer(request));
        }
        for (const ::nscd::Message& message : ranks.exchange(answers)) take(message);
        for (const auto& [home, offsets] : missing_)
        {
            for (const Vec3& offset : offsets) toVisit_.push_back({home, offset});
        }
        missing_.clear();
        return true;
    }

    ::nscd::Message answer(const ::nscd::Message& request) const
    {
        std::vector<label> wanted;
        ::nscd::unpack(request.bytes, wanted);
        std::vector<double> cells;
        for (const label cell : wanted) write(own_.copy(cell), cells);
        ::nscd::Message result{request.rank, {}};
        ::nscd::pack(cells.data(), cells.size(), result.bytes);
        return result;
    }

    void take(const ::nscd::Message& message)
    {
        std::vector<double> cells;
        ::nscd::unpack(message.bytes, cells);
        const double* at = cells.data();
        while (at < cells.data() + cells.size())
        {
            CopiedCell cell = readCell(at);
            halo_.emplace(cell.home, std::move(cell));
        }
    }

    const OwnCells& own_;
    const BoxTree& within_;
    const scalar samePlace_;
    std::vector<Visit> toVisit_;
    std::map<CellHome, std::vector<Vec3>> seen_;
    std::map<CellHome, std::vector<Vec3>> missing_;
    std::map<CellHome, CopiedCell> halo_;
};

std::vector<label> cellsToLeaveFrom(const MappingMesh& mesh, const FacesBehind& behind)
{
    std::vector<label> cells;
    for (label cell = 0; cell < mesh.nCells(); ++cell)
    {
        bool leadsAway = false;
        for (label k = mesh.cellFaceStart[cell]; k < mesh.cellFaceStart[cell + 1]; ++k)
        {
            leadsAway = leadsAway || mesh.cellFaces[k].shift != 0 || behind.count(mesh.cellFaces[k].face);
        }
        if (leadsAway) cells.push_back(cell);
    }
    return cells;
}

// Appends copied cells to the own ones.
class HaloAppender
{
public:
    HaloAppender(MappingMesh& mesh, const std::map<CellHome, CopiedCell>& halo, const FacesBehind& behind)
    :
        mesh_(mesh)
    {
        for (const auto& [home, cell] : halo)
        {
            numbers_[home] = mesh_.nOwnCells + label(mesh_.haloHomes.size());
            mesh_.haloHomes.push_back(home);
        }
        for (const auto& [faceI, across] : behind) faces_[across.name] = {faceI, 1};
        for (CellFace& cellFace : mesh_.cellFaces)
        {
            if (const auto across = behind.find(cellFace.face); across != behind.end())
            {
                cellFace.neighbor = number(across->second.cell);
                cellFace.shift = shiftNumber(across->second.shift);
            }
        }
        for (const auto& [home, cell] : halo) append(cell);
    }

private:
    struct KnownFace
    {
        label face;
        scalar sign;  // of the cell that came first
    };

    label number(const CellHome& home) const
    {
        if (home.rank < 0 || home.rank == Pstream::myProcNo())
        {
            return home.cell;
        }
        const auto known = numbers_.find(home);
        return known != numbers_.end() ? known->second : beyondHalo;
    }

    label shiftNumber(const Vec3& shift)
    {
        const auto known = std::find(mesh_.shifts.begin(), mesh_.shifts.end(), shift);
        const label number = label(known - mesh_.shifts.begin());
        if (known == mesh_.shifts.end()) mesh_.shifts.push_back(shift);
        return number;
    }

    void append(const CopiedCell& cell)
    {
        for (const CopiedFace& face : cell.faces)
        {
            const auto known = faces_.find(face.name);
            const bool isNew = known == faces_.end();
            const label faceI = isNew ? appendFace(face) : known->second.face;
            const scalar sign = isNew ? face.sign : -known->second.sign;
            mesh_.cellFaces.push_back({faceI, number(face.behind), shiftNumber(face.shift), sign});
        }
        mesh_.cellFaceStart.push_back(label(mesh_.cellFaces.size()));
        mesh_.cellCenter.push_back(cell.center);
        mesh_.cellVolume.push_back(cell.volume);
    }

    label appendFace(const CopiedFace& face)
    {
        const label faceI = label(mesh_.faceBox.size());
        for (FacePiece piece : face.pieces)
        {
            piece.firstVertex += label(mesh_.vertices.size());
            mesh_.pieces.push_back(piece);
        }
        mesh_.vertices.insert(mesh_.vertices.end(), face.vertices.begin(), face.vertices.end());
        mesh_.pieceStart.push_back(label(mesh_.pieces.size()));
        mesh_.faceBox.push_back(face.box());
        faces_[face.name] = {faceI, face.sign};
        return faceI;
    }

    MappingMesh& mesh_;
    std::map<CellHome, label> numbers_;
    std::map<FaceName, KnownFace> faces_;
};

} // namespace

void addHalo(const fvMesh& mesh, const scalar reach, MappingMesh& result)
{
    const ::nscd::Communicator ranks;
    const FacesBehind behind = findFacesBehind(mesh);
    const OwnCells own(result, behind);
    const BoxTree within = boxesWithin(mesh, result, reach);
    HaloSearch search(own, within, 1e-9*mesh.bounds().mag());
    search.start(cellsToLeaveFrom(result, behind));
    search.run(ranks);
    HaloAppender(result, search.halo(), behind);
}

} // namespace nscdCoupling
} // namespace Foam
