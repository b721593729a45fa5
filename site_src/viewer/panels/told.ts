/** What is told of a scene beside its lesson: the article that gets printed, and what tracing it did not have to do. */
export { writeArticle } from "./article";
export { createSavings } from "./savings";
