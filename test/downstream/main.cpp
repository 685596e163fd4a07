// Trains on one bag and prints the event of each episode of another: what a package that links the library needs.
#include <contact_shapelets/core/classifier.h>
#include <contact_shapelets/core/trainer.h>
#include <contact_shapelets/ros/episode_bag_reader.h>

#include <exception>
#include <iostream>

namespace core = contact_shapelets::core;

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: downstream TRAINING_BAG TEST_BAG\n";
    return 2;
  }
  try {
    const core::Classifier classifier(
        core::TrainModel(contact_shapelets::ReadEpisodes(argv[1], {}).episodes, core::TrainerOptions{}).model);
    for (const core::Episode& episode : contact_shapelets::ReadEpisodes(argv[2], {}).episodes) {
      std::cout << episode.outcome << ' ' << classifier.Classify(episode).diagnosis.event << '\n';
    }
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
