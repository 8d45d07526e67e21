// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Telling and asking the keepers.
#include "parallel/idDirectory.hpp"

namespace nscd
{

namespace
{

/// A question on its way; its number tells the one who asks where the answer belongs.
struct Question
{
    std::int64_t id;
    std::int64_t number;
};

struct Answer
{
    std::int64_t number;
    std::int64_t owner;
};

} // namespace

IdDirectory::IdDirectory(const Communicator& all, const std::vector<std::int64_t>& owned)
:
    all_(all)
{
    std::vector<int> destination;
    for (std::int64_t id : owned) destination.push_back(keeper(id));
    double duplicates = 0.0;
    for (const Message& message : all_.exchange(messagesByRank(owned, destination)))
    {
        std::vector<std::int64_t> ids;
        unpack(message.bytes, ids);
        for (std::int64_t id : ids) duplicates += owner_.emplace(id, message.rank).second ? 0.0 : 1.0;
    }
    all_.sum(&duplicates, 1);
    duplicates_ = static_cast<std::int64_t>(duplicates);
}

int IdDirectory::keeper(std::int64_t id) const
{
    const std::int64_t size = all_.size();
    return static_cast<int>((id % size + size) % size);
}

std::vector<int> IdDirectory::owners(const std::vector<std::int64_t>& ids) const
{
    std::vector<Question> questions;
    std::vector<int> destination;
    for (std::size_t k = 0; k < ids.size(); ++k)
    {
        questions.push_back({ids[k], static_cast<std::int64_t>(k)});
        destination.push_back(keeper(ids[k]));
    }
    std::vector<Answer> answers;
    std::vector<int> asker;
    for (const Message& message : all_.exchange(messagesByRank(questions, destination)))
    {
        std::vector<Question> asked;
        unpack(message.bytes, asked);
        for (const Question& question : asked)
        {
            const auto found = owner_.find(question.id);
            answers.push_back({question.number, found == owner_.end() ? -1 : found->second});
            asker.push_back(message.rank);
        }
    }
    std::vector<int> owner(ids.size(), -1);
    for (const Answer& answer : valuesOf<Answer>(all_.exchange(messagesByRank(answers, asker))))
    {
        owner[static_cast<std::size_t>(answer.number)] = static_cast<int>(answer.owner);
    }
    return owner;
}

} // namespace nscd
